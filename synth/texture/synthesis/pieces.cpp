#include "synth/texture/synthesis/pieces.h"

#include <algorithm>
#include <cmath>

#include "field/parallel.h"
#include "field/random.h"

namespace cydonia::texture {
namespace {

constexpr int kMostPieces = 768;
// The share of the mean difference in height along the common border of two pieces that
// does not count, as offsets remove it.
constexpr float kEvened = 0.5f;

int orientation_of(const Spot& middle, int orientations) {
    const std::uint64_t h = hash_of({key("piece"), std::uint64_t(middle.exemplar),
                                     std::uint64_t(middle.x), std::uint64_t(middle.y)});
    const int n = int(h % std::uint64_t(orientations));
    return orientations == 2 ? 2 * n : n;
}

// Centres of pieces along `cells` cells, at most `step` cells apart, in half cells of the
// level.
std::vector<int> middles_in(int cells, int side, int border, int step) {
    const int room = std::max(0, cells - 2 * border - side);
    const int steps = (room + step - 1) / step;
    std::vector<int> at;
    for (int i = 0; i <= steps; ++i)
        at.push_back(cells - room + (steps > 0 ? 2 * room * i / steps : room));
    return at;
}

std::vector<Spot> spread(const Character& character, int side, int border, int step,
                         int orientations) {
    const int half = character.half();
    std::vector<Spot> all, whole;  // in `whole` at least half is land
    for (int e = 0; e < character.exemplars(); ++e) {
        const Sheet& sheet = character.sheet(e);
        for (const int y : middles_in(sheet.height, side, border, step))
            for (const int x : middles_in(sheet.width, side, border, step)) {
                Spot middle{e, 0, x * half, y * half};
                int land = 0;
                for (int j = -side; j < side; j += 2)
                    for (int i = -side; i < side; i += 2)
                        land += character.is_land(
                            character.index(middle.moved({i * half, j * half})));
                middle.orientation = orientation_of(middle, orientations);
                all.push_back(middle);
                if (2 * land >= side * side) whole.push_back(middle);
            }
    }
    return whole.empty() ? all : whole;
}

// Heights and roughness of pieces along one of their edges, a column for each piece.
// Samples are every second cell along the edge and four across it.
struct Strips {
    Eigen::MatrixXf heights, roughnesses;
};
Strips strips_of(const std::vector<Spot>& middles, const Character& character, int side,
                 bool upright, int edge) {
    const int half = character.half(), along = side / 2 + 2;
    const auto count = Eigen::Index(middles.size());
    Strips strips{Eigen::MatrixXf(4 * along, count), Eigen::MatrixXf(4 * along, count)};
    parallel_for(int(count), 16, [&](int p) {
        const Spot& middle = middles[std::size_t(p)];
        for (int sample = 0; sample < 4 * along; ++sample) {
            // The distance from the piece's centre to the sample in half cells.
            const int u = edge * side + 2 * (sample % 4) - 3;
            const int v = 4 * (sample / 4) - side - 3;
            const Step s = kTurns(middle.orientation, (upright ? u : v) * half,
                                  (upright ? v : u) * half);
            const std::size_t at = character.index(middle.moved(s));
            strips.heights(sample, p) = character.height(at);
            strips.roughnesses(sample, p) = character.roughness(at);
        }
    });
    return strips;
}

// The mean squared differences between all columns of one and all of the other: |a - b|^2
// = |a|^2 + |b|^2 - 2 a.b.
Eigen::MatrixXf differences(const Eigen::MatrixXf& a, const Eigen::MatrixXf& b) {
    Eigen::MatrixXf result = -2.0f * (a.transpose() * b);
    result.colwise() += a.colwise().squaredNorm().transpose();
    result.rowwise() += b.colwise().squaredNorm();
    return result / float(a.rows());
}

Eigen::MatrixXf costs_between(const Strips& first, const Strips& second) {
    Eigen::MatrixXf costs = differences(first.heights, second.heights) +
                            differences(first.roughnesses, second.roughnesses);
    const Eigen::VectorXf a = first.heights.colwise().mean(),
                          b = second.heights.colwise().mean();
    for (Eigen::Index j = 0; j < costs.cols(); ++j)
        costs.col(j).array() -= kEvened * (a.array() - b[j]).square();
    return costs;
}

// Whether `b` follows `a` in the exemplar, give or take less than half a piece's width.
bool follows(const Spot& a, const Spot& b, int width, bool east) {
    const Step s = kTurns(a.orientation, east ? width : 0, east ? 0 : width);
    return a.exemplar == b.exemplar && a.orientation == b.orientation &&
           2 * std::max(std::abs(b.x - a.x - s.x), std::abs(b.y - a.y - s.y)) < width;
}

float same_land(const Spot& a, const Spot& b, int width) {
    if (a.exemplar != b.exemplar) return 0.0f;
    const auto both = [&](int d) {
        return float(std::max(0, width - std::abs(d))) / float(width);
    };
    return both(a.x - b.x) * both(a.y - b.y);
}

}  // namespace

Pieces pieces_of(const Character& character, int side, int border, int orientations) {
    Pieces pieces;
    int step = std::max(1, side / 8);
    pieces.middles = spread(character, side, border, step, orientations);
    while (int(pieces.middles.size()) > kMostPieces && step < 4 * side) {
        step += std::max(1, step / 4);
        pieces.middles = spread(character, side, border, step, orientations);
    }
    const auto strips = [&](bool upright, int edge) {
        return strips_of(pieces.middles, character, side, upright, edge);
    };
    pieces.west = costs_between(strips(true, 1), strips(true, -1));
    pieces.north = costs_between(strips(false, 1), strips(false, -1));
    const auto count = Eigen::Index(pieces.middles.size());
    pieces.same.resize(count, count);
    const int width = 2 * side * character.half();
    parallel_for(int(count), 16, [&](int j) {
        const Spot& b = pieces.middles[std::size_t(j)];
        for (Eigen::Index i = 0; i < count; ++i) {
            const Spot& a = pieces.middles[std::size_t(i)];
            // With seams a piece covers more than its block.
            pieces.same(i, j) = same_land(a, b, width * 4 / 3);
            if (follows(a, b, width, true)) pieces.west(i, j) += kFollowing;
            if (follows(a, b, width, false)) pieces.north(i, j) += kFollowing;
        }
    });
    return pieces;
}

}  // namespace cydonia::texture
