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

// What a ray meets first.
enum class Surface : std::uint8_t {
    kSky,
    kLand,
    kSide,       // the land's sides
    kOutskirts,  // the level country around it
    kWater,      // seas, lakes, the flood
    kThing,      // a tree, a stone
};

// A point that a pixel's centre sees, world metres. Of the sky only `ray` is known.
struct SeenPoint {
    std::array<float, 3> at{};      // where
    std::array<float, 3> normal{};  // as the frame is shaded; length 1, of water up
    float depth = 0.0f;             // along the view's axis
    Surface surface = Surface::kSky;
    std::uint8_t thing = 0;  // 1 for the scene's first kind of thing, ...
    std::uint8_t shape = 0;  // of a thing: of View::albedo
};

// What there is besides the land.
struct Scenery {
    std::optional<WaterOptions> flood = {};
    Around around = Around::kLevel;
    std::vector<ThingOptions> kinds = {};
    std::vector<std::vector<Thing>> things = {};  // of each kind
    SkyOptions sky = {};
    bool holds_image = false;  // the land, a shadow image
};
Scenery scenery_of(const Shot& shot, const Terrain& terrain);

// The land as POV-Ray draws it: the same rounded heights and mesh, its sides, what lies
// around it, the water and the things on the ground.
class View {
  public:
    // Throws bad_request unless the land is 2x2 to 16384x16384 finite heights.
    View(const Terrain& terrain, const Scenery& scenery);
    ~View();
    View(const View&) = delete;
    View& operator=(const View&) = delete;

    // A value a pixel. `smooth`: normals between the mesh's corners, as perspective
    // frames are shaded; else those of its triangles.
    Field<SeenPoint> seen(const CameraRays& rays, bool smooth) const;
    // How much of the sun is hidden from each point by the land, by things, by clouds, or
    // because the point is turned from it: 0 to 1, in the sky 0. The sun is its disc of
    // 0.53 degrees, or a point. The land's copies around it throw no shadow, as in the
    // .pov.
    enum class SunAs { kDisc, kPoint };
    Field<float> shadow(const Field<SeenPoint>& points, const Sun& sun, SunAs as) const;

    const Terrain& terrain() const;  // with rounded heights, no masks
    // Where a point is on the land: metres east and north. Of the land's copies around
    // it, what they copy.
    std::array<double, 2> on_land(const SeenPoint& point) const;
    bool has_things() const;
    Rgb albedo(const SeenPoint& thing) const;  // linear Rec.709

  private:
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

}  // namespace cydonia::render
