#pragma once

#include "field/mesh.h"
#include "field/terrain.h"
#include "field/vec.h"

namespace cydonia {

// Land as a thing to hold, in millimetres.
struct SolidOptions {
    double size = 150.0;   // its longer side; 1 to 10000
    double base = 3.0;     // of plate under the lowest ground; 0.1 to 1000
    double scale_z = 1.0;  // heights times this; 0.01 to 100
    int samples = 512;     // at most, along the longer side; 2 to 2048
};

inline constexpr int kMostSolidSamples = 2048;  // 8.4 million triangles

struct Solid {
    Mesh mesh;  // its lowest south-western corner is the origin
    Vec3 size;  // millimetres
    double millimetres_a_metre;
    int width, height;  // samples of its surface
};

// Throws bad_request when a value is out of its range, NaN included.
void expect_in_range(const SolidOptions& options);

// A closed solid: on top the mesh that is rendered (16-bit heights at the cells' centres,
// squares split NW-SE), vertical walls around, a flat plate below. Land of more samples
// is averaged down first. Of water it is the bed. Every edge lies in two triangles.
// Throws bad_request, also for a solid higher than 10 m.
Solid solid_of(const Terrain& terrain, const SolidOptions& options);

// The sun of the solid: heights times scale_z cast the same shadow under a sun whose
// elevation's tangent is as many times greater.
Sun lamp_for(const Sun& sun, const SolidOptions& options);

}  // namespace cydonia
