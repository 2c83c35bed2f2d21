#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "field/terrain.h"
#include "synth/distance/graph.h"
#include "synth/distance/options.h"

namespace cydonia::distance {

// A generator on the ground, in metres from the north-west corner.
struct SitePoint {
    float x = 0.0f, y = 0.0f;
    float cost = 0.0f;
    int root = 0;  // its index in its shape's places; elsewhere the nearest of them
};

// A feature that becomes generators. Distances, paths and directions are decided on
// `places`, which are the same for every number of samples. `land` contains the same
// generators at the land's nodes, without gaps.
struct Shape {
    std::vector<SitePoint> places;
    std::vector<SitePoint> land;
    float pitch = 0.0f;  // neighbouring places are at most this far apart, each way
    std::optional<std::array<float, 2>> centre;  // of a closed curve, where known
    // For a feature with two profiles: unit vectors (east, south) that point into the
    // side of the first, at the places that the feature had before ridges joined it.
    std::vector<std::array<float, 2>> sides;
};

// Everything that shapes and costs depend on.
class Site {
  public:
    Site(const Options& options, const Graph& graph, const Terrain& terrain,
         std::uint64_t seed);

    const Options& options;
    const Graph& graph;
    const Terrain& terrain;
    const std::uint64_t seed;
    const double width, depth;  // metres
    // A lattice that does not depend on the samples: 1024 cells along the longer side.
    const int columns, rows;

    // The graph on which paths are the same for every number of samples. It is made when
    // it is first asked for.
    const Graph& layout() const;

    bool contains(double x, double y) const {
        return x >= 0.0 && y >= 0.0 && x < width && y < depth;
    }
    SitePoint centre_of(const Graph& of, int node) const;

  private:
    mutable std::unique_ptr<Graph> layout_;
};

int node_at(const Graph& graph, double x, double y);

std::uint64_t key_of(const std::string& name);

// Appends the line from `a` to `b`, without `a`, in steps of at most `step` along each
// axis, so that it leaves out no node when nodes are `step` apart.
void append_line(std::vector<SitePoint>& line, const SitePoint& a, const SitePoint& b,
                 double step);

// Finds points by their position.
class PointIndex {
  public:
    // `reach` is about the distance, in metres, that within() will be asked for.
    explicit PointIndex(double reach) : per_metre_(1.0 / reach) {}

    void add(double x, double y, int name) {
        cells_[key(cell(x), cell(y))].push_back({x, y, name});
    }
    // Calls visit(name, squared distance) for all points within `radius` until it returns
    // false.
    template <class Visit>
    void within(double x, double y, double radius, const Visit& visit) const {
        const double most = radius * radius;
        for (std::int64_t j = cell(y - radius); j <= cell(y + radius); ++j) {
            for (std::int64_t i = cell(x - radius); i <= cell(x + radius); ++i) {
                const auto found = cells_.find(key(i, j));
                if (found == cells_.end()) continue;
                for (const Entry& entry : found->second) {
                    const double dx = entry.x - x, dy = entry.y - y;
                    const double square = dx * dx + dy * dy;
                    if (square <= most && !visit(entry.name, square)) return;
                }
            }
        }
    }
    bool any_within(double x, double y, double radius) const {
        bool any = false;
        within(x, y, radius, [&](int, double) {
            any = true;
            return false;
        });
        return any;
    }

  private:
    struct Entry {
        double x, y;
        int name;
    };
    std::int64_t cell(double metres) const {
        return static_cast<std::int64_t>(std::floor(metres * per_metre_));
    }
    static std::uint64_t key(std::int64_t i, std::int64_t j) {
        return static_cast<std::uint64_t>(j) << 32 ^
               (static_cast<std::uint64_t>(i) & 0xffffffffu);
    }

    double per_metre_;
    std::unordered_map<std::uint64_t, std::vector<Entry>> cells_;
};

}  // namespace cydonia::distance
