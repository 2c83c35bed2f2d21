// Appearance space: Lefebvre and Hoppe, "Appearance-space texture synthesis", 2006, as
// used by Gain, Merry and Marais 2015, section 4. Each component belongs to one
// irreducible representation of the square's turns and mirrorings, so that turned land
// need not be stored.
#include "synth/texture/database/appearance.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <optional>

namespace cydonia::texture {
namespace {

using Patch = Eigen::Matrix<double, 25, 1>;  // a value for each cell of a neighbourhood
using Bases = Eigen::Matrix<double, 25, Eigen::Dynamic>;

constexpr int at(Step s) { return (s.y + 2) * 5 + s.x + 2; }
constexpr Step step_of(int i) { return {i % 5 - 2, i / 5 - 2}; }

// Square roots of the Gaussian's weights, which sum to 1. As a vector of length 1 they
// are the direction of the mean, and a neighbourhood without its mean is orthogonal to
// them.
Patch root_weights() {
    constexpr double kWide = 1.25;  // cells
    Patch roots;
    for (int i = 0; i < 25; ++i) {
        const Step s = step_of(i);
        roots[i] = std::exp(-(s.x * s.x + s.y * s.y) / (4.0 * kWide * kWide));
    }
    return roots.normalized();
}

// A kind of pattern that a quarter turn and a mirroring only multiply by a sign each.
struct Kind {
    int turn, mirror;
    int sign(int orientation) const {
        return ((orientation & 1) ? turn : 1) * ((orientation & 4) ? mirror : 1);
    }
};
constexpr Kind kKinds[] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};

// An orthonormal basis of a kind: for each cell, the symmetrised pattern that is 1 there.
// Cells that are turned into one another give the same pattern, so only one of them is
// used.
template <class Spread>
Bases basis(const Spread& spread, bool (*counts)(Step)) {
    Bases result(25, 0);
    for (int i = 0; i < 25; ++i) {
        if (!counts(step_of(i))) continue;
        Patch pattern = Patch::Zero();
        spread(step_of(i), pattern);
        if (pattern.norm() < 0.5) continue;
        result.conservativeResize(Eigen::NoChange, result.cols() + 1);
        result.rightCols(1) = pattern.normalized();
    }
    return result;
}

Bases basis_of(const Kind& kind) {
    return basis(
        [&](Step s, Patch& pattern) {
            for (int o = 0; o < 8; ++o) pattern[at(turned(o, s))] += kind.sign(o);
        },
        [](Step s) { return s.x >= s.y && s.y >= 0; });
}

// A basis of the patterns that are odd in x and even in y.
Bases slope_basis() {
    return basis(
        [](Step s, Patch& pattern) {
            for (int y : {s.y, -s.y}) {
                pattern[at({s.x, y})] += 1.0;
                pattern[at({-s.x, y})] -= 1.0;
            }
        },
        [](Step s) { return s.x > 0 && s.y >= 0; });
}

Patch transposed(const Patch& pattern) {
    Patch result;
    for (int i = 0; i < 25; ++i) result[at({step_of(i).y, step_of(i).x})] = pattern[i];
    return result;
}

using Covariance = Eigen::Matrix<double, 25, 25>;

// The covariance of neighbourhoods without their mean, at about kEnough evenly spread
// cells at most.
Covariance covariance_of(const LevelArrays& level, const Patch& roots) {
    constexpr std::size_t kEnough = 100000;
    std::size_t cells = 0;
    for (const Sheet& sheet : level.sheets) cells += sheet.cells();
    const std::size_t every = 1 + cells / kEnough;
    Covariance sum = Covariance::Zero();
    std::size_t cell = 0;
    for (const Sheet& sheet : level.sheets)
        for (int y = 0; y < sheet.height; ++y)
            for (int x = 0; x < sheet.width; ++x) {
                if (cell++ % every != 0) continue;
                if (level.types[sheet.index(x, y)] == kNowhere) continue;
                Patch patch;
                for (int i = 0; i < 25; ++i) {
                    const Step s = step_of(i);
                    patch[i] = level.heights[sheet.index(x + s.x, y + s.y)] * roots[i];
                }
                patch -= patch.dot(roots) * roots;
                sum.selfadjointView<Eigen::Lower>().rankUpdate(patch);
            }
    return sum.selfadjointView<Eigen::Lower>();
}

struct Component {
    double variance;
    Patch pattern;
};

// The strongest pattern within a basis, with the sign that makes its first significant
// part positive.
Component strongest(const Covariance& covariance, const Bases& basis) {
    const Eigen::MatrixXd within = basis.transpose() * covariance * basis;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(within);
    Eigen::VectorXd parts = solver.eigenvectors().rightCols(1);
    Eigen::Index largest = 0;
    parts.cwiseAbs().maxCoeff(&largest);
    if (parts[largest] < 0.0) parts = -parts;
    return {solver.eigenvalues()[parts.size() - 1], basis * parts};
}

Modes::Weights rounded(const Patch& pattern) {
    Modes::Weights weights;
    for (std::size_t i = 0; i < 25; ++i)
        weights[i] = static_cast<std::int32_t>(
            std::lround(pattern[Eigen::Index(i)] * Modes::kOne));
    return weights;
}

// The centre, which every symmetry leaves in place, takes up the rounding error of the
// sum.
void make_sum(Modes::Weights& weights, std::int32_t sum) {
    for (std::int32_t weight : weights) sum -= weight;
    weights[12] += sum;
}

}  // namespace

Modes modes_of(const LevelArrays& level) {
    const Patch roots = root_weights();
    const Covariance covariance = covariance_of(level, roots);

    // Averaged over the eight orientations the covariance has no entries between kinds
    // (Schur's lemma), and the two halves of the slopes' block are each other's
    // transpose.
    Covariance transposed_too = covariance;
    for (int i = 0; i < 25; ++i)
        for (int j = 0; j < 25; ++j) {
            const Step a = step_of(i), b = step_of(j);
            transposed_too(i, j) += covariance(at({a.y, a.x}), at({b.y, b.x}));
        }
    const Component slope = strongest(transposed_too, slope_basis());
    std::optional<Component> last;
    Kind kind{};
    for (const Kind& other : kKinds) {
        const Component component = strongest(transposed_too, basis_of(other));
        if (last && component.variance <= last->variance) continue;
        last = component;
        kind = other;
    }

    Modes modes;
    const auto weighted = [&](const Patch& pattern) -> Patch {
        return pattern.cwiseProduct(roots);
    };
    modes.weights = {rounded(weighted(roots)), rounded(weighted(slope.pattern)),
                     rounded(weighted(transposed(slope.pattern))),
                     rounded(weighted(last->pattern))};
    make_sum(modes.weights[0], Modes::kOne);
    make_sum(modes.weights[3], 0);
    for (int o = 0; o < 8; ++o)
        modes.last_sign[std::size_t(o)] = static_cast<std::int8_t>(kind.sign(o));
    return modes;
}

}  // namespace cydonia::texture
