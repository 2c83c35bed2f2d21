#include "render/passes/passes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "field/parallel.h"
#include "field/sample.h"

namespace cydonia::render {
namespace {

// A layer whose values write(pixel, out) sets; of the sky they stay as they are.
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

// A point's place on a map that covers the land's cells, in the map's cells from the
// centre of its first.
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

}  // namespace

std::vector<PassLayer> passes(const View& view, const Field<SeenPoint>& points,
                              const Sun& sun, const PassMaps& maps,
                              const std::vector<Pass>& which) {
    const auto layer = [&](Pass pass) -> std::optional<PassLayer> {
        switch (pass) {
            case Pass::kDepth:
                return filled(
                    {"depth", {"Z"}, false, {}}, points, kFarDepth,
                    [](const SeenPoint& p, std::size_t, float* out) { *out = p.depth; });
            case Pass::kPosition:
                return filled({"position", {"P.X", "P.Y", "P.Z"}, false, {}}, points,
                              0.0f, [](const SeenPoint& p, std::size_t, float* out) {
                                  std::ranges::copy(p.at, out);
                              });
            case Pass::kNormal:
                return filled({"normal", {"N.X", "N.Y", "N.Z"}, true, {}}, points, 0.0f,
                              [](const SeenPoint& p, std::size_t, float* out) {
                                  std::ranges::copy(p.normal, out);
                              });
            case Pass::kHeight:
                return filled(
                    {"height", {"height.Y"}, false, {}}, points, 0.0f,
                    [](const SeenPoint& p, std::size_t, float* out) { *out = p.at[2]; });
            case Pass::kSlope:
                return filled({"slope", {"slope.Y"}, true, {}}, points, 0.0f,
                              [](const SeenPoint& p, std::size_t, float* out) {
                                  const double up = std::clamp(p.normal[2], -1.0f, 1.0f);
                                  *out = static_cast<float>(degrees(std::acos(up)));
                              });
            case Pass::kMaterial:
                if (maps.materials.empty()) return std::nullopt;
                return filled({"material", {"material.Y"}, true, {}}, points, 0.0f,
                              [&](const SeenPoint& p, std::size_t, float* out) {
                                  if (p.surface != Surface::kLand) return;
                                  *out = 1.0f + nearest(maps.materials,
                                                        on_map(maps.materials, view, p));
                              });
            case Pass::kType:
                if (maps.types.empty()) return std::nullopt;
                return filled({"type", {"type.Y"}, true, {}}, points, 0.0f,
                              [&](const SeenPoint& p, std::size_t, float* out) {
                                  if (p.surface != Surface::kLand) return;
                                  *out = nearest(maps.types, on_map(maps.types, view, p));
                              });
            case Pass::kThing:
                if (!view.has_things()) return std::nullopt;
                return filled(
                    {"thing", {"thing.Y"}, true, {}}, points, 0.0f,
                    [](const SeenPoint& p, std::size_t, float* out) { *out = p.thing; });
            case Pass::kShadow: {
                const Field<float> shadow = view.shadow(points, sun, View::SunAs::kDisc);
                return filled({"shadow", {"shadow.Y"}, true, {}}, points, 0.0f,
                              [&](const SeenPoint&, std::size_t i, float* out) {
                                  *out = shadow[i];
                              });
            }
            case Pass::kMotion:
                return std::nullopt;  // motion_pass: it takes two cameras
            case Pass::kSky:
                if (maps.sky_visibility.empty()) return std::nullopt;
                return filled({"sky", {"sky.Y"}, true, {}}, points, 0.0f,
                              [&](const SeenPoint& p, std::size_t, float* out) {
                                  const OnMap at = on_map(maps.sky_visibility, view, p);
                                  const bool over_land = p.surface == Surface::kLand ||
                                                         p.surface == Surface::kThing;
                                  *out = over_land
                                             ? bilinear(maps.sky_visibility, at.x, at.y)
                                         : p.surface == Surface::kSide ? 0.5f
                                                                       : 1.0f;
                              });
        }
        return std::nullopt;
    };
    std::vector<PassLayer> layers;
    for (const Pass pass : which)
        if (auto made = layer(pass)) layers.push_back(std::move(*made));
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
