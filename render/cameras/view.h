#pragma once

#include <algorithm>
#include <optional>

#include "field/camera.h"
#include "field/terrain.h"
#include "render/options.h"

// The land as cameras stand on it and see it. Lengths in metres of the world.
namespace cydonia::render {

// Heights of water where there is some, seas, lakes and the flood; else of land.
Terrain surface_of(const Terrain& terrain, const std::optional<WaterOptions>& flood);

// The height of the mesh over a place; of its border outside.
double ground_at(const Terrain& terrain, double east, double north);
bool over_land(const Terrain& terrain, const Vec3& point);
// What lies around the land.
Around around_of(const Terrain& terrain, const Options& options);
// Of the level country around the land: that of its lowest border.
double outskirts_height(const Terrain& terrain);

// What a pixel covers where the camera looks, metres.
double pixel_size(const Camera& camera);
// Whether land is shaded between the corners of its mesh. From above flat triangles show
// what the shadow check casts; those of a few pixels need no smoothing, and POV-Ray's
// smooth ones let sunlight through at crests.
bool is_smooth(const Camera& camera, const Terrain& terrain);

double aspect(const Camera& camera);  // width over height of its frame
// A point as the camera sees it: to the right, up and forward, metres.
Vec3 seen(const Camera& camera, const Vec3& point);
bool in_frame(const Camera& camera, const Vec3& point);  // perspective

// Where a ray first meets the land; none beyond its sides. `direction` has length 1.
std::optional<Vec3> where_it_meets(const Terrain& terrain, const Vec3& from,
                                   const Vec3& direction);

constexpr int kLooks = 256;  // samples a side that stand for the land in a frame

// Calls visit(point) for samples all over the land, its border included.
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
