#include "synth/texture/synthesis/patches.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "field/parallel.h"
#include "synth/texture/synthesis/origins.h"

// Gain, Merry and Marais 2015, figure 3: how patches form.

namespace cydonia::texture {

namespace {

constexpr int kBlock = 16;

// The column and the row of the exemplar's cell.
int column(Origin place, int level) { return spot_of(place).x >> (level + 1); }
int row(Origin place, int level) { return spot_of(place).y >> (level + 1); }

// Whether the land at `to`, one step from `from`, is what the exemplar has one step away.
bool goes_on(Origin from, Origin to, Step step, int level) {
    const Step there = turned(from.orientation(), step);
    const Spot a = spot_of(from), b = spot_of(to);
    return a.exemplar == b.exemplar && a.orientation == b.orientation &&
           a.x + there.x * (2 << level) == b.x && a.y + there.y * (2 << level) == b.y;
}

bool coherent(const Field<Origin>& origins, int level, int x, int y) {
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (origins.contains(x + dx, y + dy) &&
                !goes_on(origins(x, y), origins(x + dx, y + dy), {dx, dy}, level)) {
                return false;
            }
    return true;
}

double coherent_share(const Field<Origin>& origins, int level) {
    std::vector<int> count(static_cast<std::size_t>(origins.height()));
    parallel_for(origins.height(), 16, [&](int y) {
        for (int x = 0; x < origins.width(); ++x)
            count[static_cast<std::size_t>(y)] += coherent(origins, level, x, y);
    });
    return std::accumulate(count.begin(), count.end(), 0.0) /
           static_cast<double>(origins.size());
}

// Disjoint sets of cells (union-find), each named by its first cell. Whether two
// neighbours belong together depends on both, which OpenCV's connectedComponents cannot
// express.
class Sets {
  public:
    explicit Sets(std::size_t cells) : parent_(cells) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    std::uint32_t first(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        std::tie(a, b) = std::minmax({first(a), first(b)});
        parent_[b] = a;
    }

  private:
    std::vector<std::uint32_t> parent_;
};

// The number of cells of each patch, the largest first. Patches are connected by the
// sides of cells.
std::vector<std::int64_t> patch_sizes(const Field<Origin>& origins, int level) {
    Sets sets(origins.size());
    const auto join = [&](int x, int y, Step step) {
        if (!origins.contains(x + step.x, y + step.y)) return;
        const std::size_t a = origins.index(x, y),
                          b = origins.index(x + step.x, y + step.y);
        if (goes_on(origins[a], origins[b], step, level))
            sets.join(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
    };
    for (int y = 0; y < origins.height(); ++y)
        for (int x = 0; x < origins.width(); ++x) {
            join(x, y, {1, 0});
            join(x, y, {0, 1});
        }
    std::vector<std::int64_t> sizes(origins.size());
    for (std::uint32_t i = 0; i < origins.size(); ++i) ++sizes[sets.first(i)];
    std::erase(sizes, 0);
    std::ranges::sort(sizes, std::greater());
    return sizes;
}

std::int64_t half_way(const std::vector<std::int64_t>& sizes, std::size_t cells) {
    std::size_t sum = 0;
    for (std::int64_t size : sizes)
        if (2 * (sum += static_cast<std::size_t>(size)) >= cells) return size;
    return 0;
}

// Blocks that extend beyond an exemplar do not count.
double used_share(const Database& database, const Field<Origin>& origins, int level) {
    struct Blocks {
        int across, down;
        std::vector<char> used;
    };
    std::vector<Blocks> exemplars;
    for (const Sheet& sheet : database.levels.at(std::size_t(level)).sheets) {
        const int across = sheet.width / kBlock, down = sheet.height / kBlock;
        exemplars.push_back(
            {across, down, std::vector<char>(static_cast<std::size_t>(across * down))});
    }
    for (Origin place : origins) {
        Blocks& blocks = exemplars.at(static_cast<std::size_t>(place.exemplar()));
        const int x = column(place, level) / kBlock, y = row(place, level) / kBlock;
        if (x < blocks.across && y < blocks.down)
            blocks.used[static_cast<std::size_t>(y * blocks.across + x)] = 1;
    }
    double used = 0.0, all = 0.0;
    for (const Blocks& blocks : exemplars) {
        used += static_cast<double>(std::ranges::count(blocks.used, 1));
        all += static_cast<double>(blocks.used.size());
    }
    return all > 0.0 ? used / all : 0.0;
}

}  // namespace

PatchFigures patch_figures(const Database& database, const Field<Origin>& origins,
                           int level) {
    if (origins.empty()) return {};
    const std::vector<std::int64_t> sizes = patch_sizes(origins, level);
    return {.coherent = coherent_share(origins, level),
            .patches = static_cast<int>(sizes.size()),
            .typical = half_way(sizes, origins.size()),
            .largest = sizes.front(),
            .used = used_share(database, origins, level)};
}

Field<Rgb8> source_map(const Database& database, const Field<Origin>& origins,
                       int level) {
    const auto share = [](double part, double of) {
        return static_cast<std::uint8_t>(
            std::lround(255.0 * std::clamp(part / std::max(of, 1.0), 0.0, 1.0)));
    };
    const auto sheets = database.levels.at(std::size_t(level)).sheets;
    Field<Rgb8> map(origins.width(), origins.height());
    for (std::size_t i = 0; i < map.size(); ++i) {
        const int exemplar = origins[i].exemplar();
        const Sheet& sheet = sheets[static_cast<std::size_t>(exemplar)];
        map[i] = {share(column(origins[i], level), sheet.width - 1),
                  share(row(origins[i], level), sheet.height - 1),
                  share(exemplar, static_cast<double>(sheets.size()) - 1.0)};
    }
    return map;
}

}  // namespace cydonia::texture
