#include "synth/pareidolia/constrained/contradictions.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <queue>
#include <tuple>

#include "synth/pareidolia/constrained/light_rows.h"

namespace cydonia::pareidolia {
namespace {

// A cell under one of the suns: image * cells + cell.
using Label = std::uint32_t;
using Quadruple = std::array<Label, 4>;

constexpr int kRounds =
    6;  // relaxed cells cast no shadow, and new casters may contradict

// What one image requires of the cells.
class Asked {
  public:
    explicit Asked(const ShadowImage& image)
        : image_(image),
          width_(image.target.width()),
          height_(image.target.height()),
          reach_(width_, height_) {
        const LightRows rows(width_, height_, image.sun.azimuth, Stops::kColumns);
        const auto from = rows.position(0.0, 0), to = rows.position(1.0, 0);
        dx_ = to.x - from.x;
        dy_ = to.y - from.y;
        for (int row = 0; row < rows.rows(); ++row) {
            int last_lit = -1;
            for (int i = rows.span(row).first; i < rows.span(row).past; ++i) {
                const auto [x, y] = cell_of(rows.position(i, row));
                if (!reach_.contains(x, y)) continue;
                if (!shadow(x, y))
                    last_lit = i;
                else if (last_lit >= 0)
                    reach_(x, y) = static_cast<float>(i - last_lit);
            }
        }
    }

    bool lit(int x, int y) const {
        return inside(x, y) && !gave_way(x, y) && !image_.target(x, y) &&
               (image_.window.empty() || image_.window(x, y));
    }
    bool shadow(int x, int y) const {
        return inside(x, y) && !gave_way(x, y) && image_.target(x, y);
    }
    bool inside(int x, int y) const { return reach_.contains(x, y); }
    float reach(int x, int y) const { return reach_(x, y); }  // columns to the caster
    double dx() const { return dx_; }                         // of the light, a column
    double dy() const { return dy_; }

  private:
    bool gave_way(int x, int y) const {
        return !image_.relaxed.empty() && image_.relaxed(x, y);
    }
    const ShadowImage& image_;
    int width_, height_;
    Field<float> reach_;
    double dx_ = 0.0, dy_ = 0.0;
};

void find(const Asked& first, const Asked& second, Label of_first, Label of_second,
          int width, int height, std::vector<Quadruple>& found) {
    const auto label = [width](Label base, int x, int y) {
        return base + static_cast<Label>(y) * static_cast<Label>(width) +
               static_cast<Label>(x);
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {  // d
            if (!first.lit(x, y) || !second.shadow(x, y) || second.reach(x, y) <= 0.0f)
                continue;
            const double back = second.reach(x, y);
            const auto [bx, by] =
                cell_of({x - back * second.dx(), y - back * second.dy()});
            if (!first.shadow(bx, by) || first.reach(bx, by) <= 0.0f) continue;
            const double aside = first.reach(bx, by);
            const auto [cx, cy] =
                cell_of({x - aside * first.dx(), y - aside * first.dy()});
            if (!second.lit(cx, cy)) continue;
            found.push_back({label(of_first, x, y), label(of_second, x, y),
                             label(of_first, bx, by), label(of_second, cx, cy)});
        }
}

std::vector<Quadruple> quadruples_of(const std::vector<ShadowImage>& images) {
    std::vector<Asked> asked;
    for (const ShadowImage& image : images) asked.emplace_back(image);
    const int width = images.front().target.width();
    const int height = images.front().target.height();
    const auto cells = static_cast<Label>(images.front().target.size());
    std::vector<Quadruple> found;
    for (Label i = 0; i < asked.size(); ++i)
        for (Label j = 0; j < asked.size(); ++j)
            if (i != j)
                find(asked[i], asked[j], i * cells, j * cells, width, height, found);
    return found;
}

std::size_t disjoint(const std::vector<Quadruple>& quadruples, std::size_t labels) {
    std::vector<bool> used(labels);
    std::size_t count = 0;
    for (const Quadruple& q : quadruples) {
        if (std::ranges::any_of(q, [&](Label l) { return used[l]; })) continue;
        for (const Label l : q) used[l] = true;
        ++count;
    }
    return count;
}

// Labels that hit every quadruple, by the greedy rule; of equal labels the first.
std::vector<Label> hitting(const std::vector<Quadruple>& quadruples, std::size_t labels) {
    std::vector<std::uint32_t> degree(labels + 1), begin(labels + 1);
    for (const Quadruple& q : quadruples)
        for (const Label l : q) ++degree[l];
    for (std::size_t l = 0; l < labels; ++l) begin[l + 1] = begin[l] + degree[l];
    std::vector<std::uint32_t> members(quadruples.size() * 4), at(begin);
    for (std::uint32_t q = 0; q < quadruples.size(); ++q)
        for (const Label l : quadruples[q]) members[at[l]++] = q;

    struct Candidate {
        std::uint32_t degree;
        Label label;
        bool operator<(const Candidate& o) const {
            return std::tie(degree, o.label) < std::tie(o.degree, label);
        }
    };
    std::priority_queue<Candidate> queue;
    for (Label l = 0; l < labels; ++l)
        if (degree[l] > 0) queue.push({degree[l], l});
    std::vector<bool> settled(quadruples.size());
    std::vector<Label> result;
    while (!queue.empty()) {
        const auto [known, label] = queue.top();
        queue.pop();
        if (degree[label] == 0) continue;
        if (degree[label] < known) {
            queue.push({degree[label], label});
            continue;
        }
        result.push_back(label);
        for (std::uint32_t m = begin[label]; m < begin[label + 1]; ++m) {
            if (settled[members[m]]) continue;
            settled[members[m]] = true;
            for (const Label l : quadruples[members[m]]) --degree[l];
        }
    }
    return result;
}

}  // namespace

Contradictions settle(std::vector<ShadowImage>& images) {
    Contradictions result;
    if (images.size() < 2) return result;
    const std::size_t cells = images.front().target.size();
    for (int round = 0; round < kRounds; ++round) {
        const std::vector<Quadruple> found = quadruples_of(images);
        if (round == 0) {
            result.quadruples = found.size();
            result.least_wrong = disjoint(found, cells * images.size());
        }
        if (found.empty()) break;
        for (const Label label : hitting(found, cells * images.size())) {
            ShadowImage& image = images[label / cells];
            if (image.relaxed.empty())
                image.relaxed =
                    Field<std::uint8_t>(image.target.width(), image.target.height());
            image.relaxed[label % cells] = 1;
            ++result.relaxed;
        }
    }
    // In the best case all of them are wrong shadow of the image that has most of it.
    double most = 0.0;
    for (const ShadowImage& image : images)
        most = std::max(most, static_cast<double>(std::count(image.target.begin(),
                                                             image.target.end(), 1)));
    const auto count = static_cast<double>(images.size());
    const double wrong = static_cast<double>(result.least_wrong);
    if (most > 0.0) result.bound = (count - 1.0 + most / (most + wrong)) / count;
    return result;
}

}  // namespace cydonia::pareidolia
