#include "synth/hydrology/breach.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "synth/hydrology/depressions.h"
#include "synth/hydrology/neighbours.h"

namespace cydonia::hydrology {
namespace {

constexpr double kFall = 0.02;    // steepest fall of a channel, rise over run
constexpr double kBank = 0.6;     // steepest bank that digging makes, rise over run
constexpr double kDeepest = 1.0;  // cut of a channel, in widths of a cell
// The cost of crossing a cell, in metres of material per metre of its width. It makes
// channels straight on flat land.
constexpr double kWay = 0.001;

using Path = std::vector<std::int32_t>;  // from the minimum to lower land

// Finds the cheapest path from a minimum to lower land or over the land's edge, within a
// square around the minimum (Dijkstra).
class Search {
  public:
    Search(const Field<float>& heights, const Field<std::uint8_t>& locked, double spacing,
           int radius)
        : heights_(heights),
          locked_(locked),
          way_(kWay * spacing),
          deepest_(kDeepest * spacing),
          radius_(radius),
          side_(2 * radius + 1),
          nodes_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_)) {}

    std::optional<Path> way_out(std::int32_t minimum) {
        begin(minimum);
        while (!open_.empty()) {
            std::ranges::pop_heap(open_, std::greater{});
            const auto [cost, cell] = open_.back();
            open_.pop_back();
            if (cost > node(cell).cost) continue;  // a cheaper path was found since
            if (heights_[cell] < floor_ || (cell != minimum && at_edge(heights_, cell)))
                return path_to(cell);
            for_neighbours(
                heights_, cell,
                [&, from = cell, spent = cost](std::int32_t next, double distance) {
                    if (inside(next) && passable(next))
                        offer(next, from, spent + price(next) * distance);
                });
        }
        return std::nullopt;
    }

  private:
    struct Node {
        int search = 0;  // number of the last search that reached the cell
        double cost = 0.0;
        std::int32_t from = -1;
    };

    void begin(std::int32_t minimum) {
        ++search_;
        floor_ = heights_[minimum];
        x0_ = minimum % heights_.width() - radius_;
        y0_ = minimum / heights_.width() - radius_;
        open_.clear();
        offer(minimum, -1, 0.0);
    }
    bool inside(std::int32_t cell) const {
        const int x = cell % heights_.width() - x0_, y = cell / heights_.width() - y0_;
        return x >= 0 && y >= 0 && x < side_ && y < side_;
    }
    Node& node(std::int32_t cell) {
        const int x = cell % heights_.width() - x0_, y = cell / heights_.width() - y0_;
        return nodes_[static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) +
                      static_cast<std::size_t>(x)];
    }
    bool passable(std::int32_t cell) const {
        const float height = heights_[cell];
        if (height < floor_) return true;
        return double(height) - floor_ <= deepest_ && (locked_.empty() || !locked_[cell]);
    }
    double price(std::int32_t cell) const {
        return std::max(0.0, double(heights_[cell]) - floor_) + way_;
    }
    void offer(std::int32_t cell, std::int32_t from, double cost) {
        Node& n = node(cell);
        if (n.search == search_ && n.cost <= cost) return;
        n = {search_, cost, from};
        open_.emplace_back(cost, cell);
        std::ranges::push_heap(open_, std::greater{});
    }
    Path path_to(std::int32_t end) {
        Path path;
        for (std::int32_t cell = end; cell >= 0; cell = node(cell).from)
            path.push_back(cell);
        std::ranges::reverse(path);
        return path;
    }

    const Field<float>& heights_;
    const Field<std::uint8_t>& locked_;
    double way_, deepest_;
    int radius_, side_;
    std::vector<Node> nodes_;
    std::vector<std::pair<double, std::int32_t>> open_;  // a heap, cheapest on top
    int search_ = 0;
    float floor_ = 0.0f;  // height of the minimum
    int x0_ = 0, y0_ = 0;
};

// Lowers the land along paths, and beside them where banks would be too steep. Every
// lowered cell has a neighbour that is not higher and leads out, so no new minimum
// appears.
class Spade {
  public:
    Spade(Field<float>& heights, const Field<std::uint8_t>& locked, double spacing)
        : heights_(heights), before_(heights), locked_(locked), spacing_(spacing) {}

    // False where nothing had to be lowered.
    bool dig(const Path& path) {
        const double top = heights_[path.front()], end = heights_[path.back()];
        const auto steps = static_cast<double>(path.size() - 1);
        // A path over the land's edge falls as gently as the limit allows.
        const double fall =
            end < top ? std::min((top - end) / steps, kFall * spacing_) : kWay * spacing_;
        const std::size_t to_dig = path.size() - (end < top ? 1 : 0);
        bool dug = false;
        for (std::size_t i = 1; i < to_dig; ++i)
            dug |= lower(path[i], top - static_cast<double>(i) * fall);
        lay_banks();
        return dug;
    }
    float deepest() const { return deepest_; }

  private:
    bool lower(std::int32_t cell, double height) {
        const auto to = static_cast<float>(height);
        if (!(to < heights_[cell])) return false;
        heights_[cell] = to;
        deepest_ = std::max(deepest_, before_[cell] - to);
        fresh_.push_back(cell);
        return true;
    }
    void lay_banks() {
        while (!fresh_.empty()) {
            const std::int32_t cell = fresh_.back();
            fresh_.pop_back();
            for_neighbours(heights_, cell, [&](std::int32_t next, double distance) {
                if (!locked_.empty() && locked_[next]) return;
                const double rise = std::max<double>(kBank * spacing_ * distance,
                                                     before_[next] - before_[cell]);
                lower(next, heights_[cell] + rise);
            });
        }
    }

    Field<float>& heights_;
    const Field<float> before_;
    const Field<std::uint8_t>& locked_;
    double spacing_;
    float deepest_ = 0.0f;
    std::vector<std::int32_t>
        fresh_;  // lowered cells whose neighbours are still to be checked
};

}  // namespace

Breached breach(Field<float>& heights, double spacing, const Field<std::uint8_t>& locked,
                int radius) {
    Breached done;
    Search search(heights, locked, spacing, radius);
    Spade spade(heights, locked, spacing);
    std::vector<std::int32_t> left = minima_of(heights);
    // Repeated, because a later channel may run lower than a minimum that had no way out
    // before.
    for (int before = -1; done.cut != before;) {
        before = done.cut;
        std::erase_if(left, [&](std::int32_t minimum) {
            const auto path = search.way_out(minimum);
            if (path) done.cut += spade.dig(*path);
            return path.has_value();
        });
    }
    done.left = static_cast<int>(left.size());
    done.deepest = spade.deepest();
    return done;
}

}  // namespace cydonia::hydrology
