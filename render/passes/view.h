#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "field/field.h"
#include "field/terrain.h"
#include "render/options.h"
#include "render/passes/camera_rays.h"

namespace cydonia::render {

// What a ray meets first.
enum class Surface : std::uint8_t {
    kSky,
    kLand,
    kSide,       // the land's sides
    kOutskirts,  // the level country around it
    kWater,      // seas, lakes, the flood
};

// A point that a pixel's centre sees, world metres. Of the sky only `ray` is known.
struct SeenPoint {
    std::array<float, 3> at{};      // where
    std::array<float, 3> normal{};  // as the frame is shaded; length 1, of water up
    float depth = 0.0f;             // along the view's axis
    Surface surface = Surface::kSky;
};

// The land as POV-Ray draws it: the same rounded heights and mesh, its sides, the
// outskirts and the water. Things on the ground are not in it.
class View {
  public:
    // Throws bad_request unless the land is 2x2 to 16384x16384 finite heights.
    View(const Terrain& terrain, const std::optional<WaterOptions>& flood);
    ~View();
    View(const View&) = delete;
    View& operator=(const View&) = delete;

    // A value a pixel. `smooth`: normals between the mesh's corners, as perspective
    // frames are shaded; else those of its triangles.
    Field<SeenPoint> seen(const CameraRays& rays, bool smooth) const;
    // 1 where the point is in the land's shadow or turned from the sun, 0 where lit and
    // in the sky. A sharp sun.
    Field<std::uint8_t> shadow(const Field<SeenPoint>& points, const Sun& sun) const;

    const Terrain& terrain() const;  // with rounded heights, no masks

  private:
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

}  // namespace cydonia::render
