#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "field/field.h"
#include "field/terrain.h"
#include "render/passes/camera_rays.h"
#include "render/scene/shot.h"
#include "render/things/placement.h"

namespace cydonia::render {

// The kind of surface that a ray hits first.
enum class Surface : std::uint8_t {
    kSky,
    kLand,
    kSide,       // the side walls of the land
    kOutskirts,  // the level country around it
    kWater,      // seas, lakes, the flood
    kThing,      // a tree, a stone
};

// The point that a pixel's centre sees, world metres. For the sky only `surface` is set.
struct SeenPoint {
    std::array<float, 3> at{};  // where
    std::array<float, 3>
        normal{};        // shading normal of length 1; water has a vertical one
    float depth = 0.0f;  // along the view's axis
    Surface surface = Surface::kSky;
    std::uint8_t thing = 0;  // kind of thing: 1 for the scene's first; 0 for none
    std::uint8_t shape = 0;  // part of a thing, for View::albedo
};

// What surrounds the land and stands on it.
struct Scenery {
    std::optional<WaterOptions> flood = {};
    Around around = Around::kLevel;
    std::vector<ThingOptions> kinds = {};
    std::vector<std::vector<Thing>> things = {};  // of each kind
    SkyOptions sky = {};
    bool holds_image = false;  // whether the land shows a shadow image
};
Scenery scenery_of(const Shot& shot, const Terrain& terrain);

// The land as POV-Ray draws it, for rays: the same rounded heights and mesh, its side
// walls, its surroundings, the water and the things on the ground.
class View {
  public:
    // Throws bad_request unless the land is 2x2 to 16384x16384 finite heights.
    View(const Terrain& terrain, const Scenery& scenery);
    ~View();
    View(const View&) = delete;
    View& operator=(const View&) = delete;

    // The point that each pixel sees. With `smooth` normals are interpolated over the
    // mesh, as perspective frames are shaded; otherwise they are those of its triangles.
    Field<SeenPoint> seen(const CameraRays& rays, bool smooth) const;
    // The share of the sun that is occluded at each point, 0 to 1, by the land, by
    // things, by clouds or because the surface faces away; 0 in the sky. The sun is a
    // disc of 0.53 degrees or a point. Copies of the land cast no shadow, as in the .pov.
    enum class SunAs { kDisc, kPoint };
    Field<float> shadow(const Field<SeenPoint>& points, const Sun& sun, SunAs as) const;

    const Terrain& terrain() const;  // with rounded heights, no masks
    // The corresponding point of the land, metres east and north, of a point on the land
    // or on a copy of it.
    std::array<double, 2> on_land(const SeenPoint& point) const;
    bool has_things() const;
    Rgb albedo(const SeenPoint& thing) const;  // linear Rec.709

  private:
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

}  // namespace cydonia::render
