#pragma once

#include <algorithm>
#include <optional>

#include "field/camera.h"
#include "field/terrain.h"
#include "render/options.h"

// The land as cameras stand on it and see it. Lengths are in metres.
namespace cydonia::render {

// The land with its water filled in: seas, lakes and the flood become ground.
Terrain surface_of(const Terrain& terrain, const std::optional<WaterOptions>& flood);

// The height of the mesh at a point; outside the land, that of its nearest border.
double ground_at(const Terrain& terrain, double east, double north);
bool over_land(const Terrain& terrain, const Vec3& point);
// What lies around the land.
Around around_of(const Terrain& terrain, const Options& options);
// The height of the level country around the land, which is that of its lowest border.
double outskirts_height(const Terrain& terrain);

// The width that a pixel covers at the camera's target, metres.
double pixel_size(const Camera& camera);
// Whether the land is drawn with smooth normals. From above it is not, because flat
// triangles show what the shadow check casts. Triangles of a few pixels need no
// smoothing, and POV-Ray's smooth triangles let sunlight through at crests.
bool is_smooth(const Camera& camera, const Terrain& terrain);

double aspect(const Camera& camera);  // width over height of its frame
// A point in the camera's space: metres to the right, up and forward.
Vec3 seen(const Camera& camera, const Vec3& point);
bool in_frame(const Camera& camera, const Vec3& point);  // perspective

// The first point where a ray hits the land, if any. `direction` has length 1.
std::optional<Vec3> where_it_meets(const Terrain& terrain, const Vec3& from,
                                   const Vec3& direction);

constexpr int kLooks = 256;  // samples a side that represent the land in tests of a frame

// Calls visit(point) for samples spread over the land, its border included.
template <class Visit>
void look_over(const Terrain& t, const Visit& visit) {
    const int w = t.heights.width(), h = t.heights.height();
    const int columns = std::min(w, kLooks), rows = std::min(h, kLooks);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const int x = i * (w - 1) / (columns - 1), y = j * (h - 1) / (rows - 1);
            visit(
                Vec3{t.spacing * (x + 0.5), t.spacing * (h - y - 0.5), t.heights(x, y)});
        }
}

}  // namespace cydonia::render
