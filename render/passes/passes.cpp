#include "render/passes/passes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "field/parallel.h"
#include "field/sample.h"

namespace cydonia::render {
namespace {

// A layer whose values are set by write(point, pixel, out), or to `of_sky` in the sky.
template <class Write>
PassLayer filled(PassLayer layer, const Field<SeenPoint>& points, float of_sky,
                 const Write& write) {
    const std::size_t channels = layer.channels.size();
    layer.values.assign(points.size() * channels, of_sky);
    parallel_for(points.height(), 16, [&](int y) {
        for (int x = 0; x < points.width(); ++x) {
            const std::size_t i = points.index(x, y);
            if (points[i].surface != Surface::kSky)
                write(points[i], i, layer.values.data() + i * channels);
        }
    });
    return layer;
}

// The position of a point on a map that covers the land's cells, in pixels of the map
// from the centre of its first.
struct OnMap {
    double x, y;
};
template <class T>
OnMap on_map(const Field<T>& map, const View& view, const SeenPoint& p) {
    const Terrain& land = view.terrain();
    const auto [east, north] = view.on_land(p);
    return {east / land.width() * map.width() - 0.5,
            (1.0 - north / land.depth()) * map.height() - 0.5};
}

template <class T>
T nearest(const Field<T>& map, OnMap at) {
    return map(std::clamp(static_cast<int>(std::lround(at.x)), 0, map.width() - 1),
               std::clamp(static_cast<int>(std::lround(at.y)), 0, map.height() - 1));
}

// What the passes of one frame are made from.
struct Seen {
    const View& view;
    const Field<SeenPoint>& points;
    const Sun& sun;
    const PassMaps& maps;
};

// The layer of a pass with one channel, "slope.Y", that write(point, pixel) gives.
template <class Write>
PassLayer single(Pass pass, bool half, const Seen& seen, const Write& write) {
    const std::string name(name_of(pass));
    return filled(
        {name, {name + ".Y"}, half, {}}, seen.points, 0.0f,
        [&](const SeenPoint& p, std::size_t i, float* out) { *out = write(p, i); });
}

// The value of a map of the land where a point is on it, 0 elsewhere.
PassLayer of_land(Pass pass, const Field<std::uint8_t>& map, float added,
                  const Seen& seen) {
    return single(pass, true, seen, [&](const SeenPoint& p, std::size_t) {
        if (p.surface != Surface::kLand) return 0.0f;
        return added + nearest(map, on_map(map, seen.view, p));
    });
}

PassLayer depth_layer(const Seen& seen) {
    return filled({"depth", {"Z"}, false, {}}, seen.points, kFarDepth,
                  [](const SeenPoint& p, std::size_t, float* out) { *out = p.depth; });
}

PassLayer position_layer(const Seen& seen) {
    return filled({"position", {"P.X", "P.Y", "P.Z"}, false, {}}, seen.points, 0.0f,
                  [](const SeenPoint& p, std::size_t, float* out) {
                      std::ranges::copy(p.at, out);
                  });
}

PassLayer normal_layer(const Seen& seen) {
    return filled({"normal", {"N.X", "N.Y", "N.Z"}, true, {}}, seen.points, 0.0f,
                  [](const SeenPoint& p, std::size_t, float* out) {
                      std::ranges::copy(p.normal, out);
                  });
}

PassLayer shadow_layer(const Seen& seen) {
    const Field<float> shadow =
        seen.view.shadow(seen.points, seen.sun, View::SunAs::kDisc);
    return single(Pass::kShadow, true, seen,
                  [&](const SeenPoint&, std::size_t i) { return shadow[i]; });
}

PassLayer sky_layer(const Seen& seen) {
    const Field<float>& map = seen.maps.sky_visibility;
    return single(Pass::kSky, true, seen, [&](const SeenPoint& p, std::size_t) {
        if (p.surface == Surface::kSide) return 0.5f;  // half the sky, as any wall
        if (p.surface != Surface::kLand && p.surface != Surface::kThing) return 1.0f;
        const OnMap at = on_map(map, seen.view, p);
        return static_cast<float>(bilinear(map, at.x, at.y));
    });
}

// Nothing where the data are missing.
std::optional<PassLayer> layer_of(Pass pass, const Seen& seen) {
    switch (pass) {
        case Pass::kDepth:
            return depth_layer(seen);
        case Pass::kPosition:
            return position_layer(seen);
        case Pass::kNormal:
            return normal_layer(seen);
        case Pass::kHeight:
            return single(pass, false, seen,
                          [](const SeenPoint& p, std::size_t) { return p.at[2]; });
        case Pass::kSlope:
            return single(pass, true, seen, [](const SeenPoint& p, std::size_t) {
                const double up = std::clamp(p.normal[2], -1.0f, 1.0f);
                return static_cast<float>(degrees(std::acos(up)));
            });
        case Pass::kMaterial:
            if (seen.maps.materials.empty()) return std::nullopt;
            return of_land(pass, seen.maps.materials, 1.0f, seen);
        case Pass::kType:
            if (seen.maps.types.empty()) return std::nullopt;
            return of_land(pass, seen.maps.types, 0.0f, seen);
        case Pass::kThing:
            if (!seen.view.has_things()) return std::nullopt;
            return single(pass, true, seen, [](const SeenPoint& p, std::size_t) {
                return static_cast<float>(p.thing);
            });
        case Pass::kShadow:
            return shadow_layer(seen);
        case Pass::kSky:
            if (seen.maps.sky_visibility.empty()) return std::nullopt;
            return sky_layer(seen);
        case Pass::kMotion:
            return std::nullopt;  // motion_pass(): it takes two cameras
    }
    return std::nullopt;
}

}  // namespace

std::vector<PassLayer> passes(const View& view, const Field<SeenPoint>& points,
                              const Sun& sun, const PassMaps& maps,
                              const std::vector<Pass>& which) {
    const Seen seen{view, points, sun, maps};
    std::vector<PassLayer> layers;
    for (const Pass pass : which)
        if (auto made = layer_of(pass, seen)) layers.push_back(std::move(*made));
    return layers;
}

PassLayer motion_pass(const Field<SeenPoint>& points, const CameraRays& now,
                      const CameraRays& then) {
    return filled({"motion", {"motion.X", "motion.Y"}, false, {}}, points, 0.0f,
                  [&](const SeenPoint& p, std::size_t, float* out) {
                      const Vec3 at{p.at[0], p.at[1], p.at[2]};
                      const auto from = now.project(at), to = then.project(at);
                      if (to.depth <= 0.0) return;
                      out[0] = static_cast<float>(to.x - from.x);
                      out[1] = static_cast<float>(to.y - from.y);
                  });
}

}  // namespace cydonia::render
