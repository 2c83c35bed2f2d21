#pragma once

#include <array>

#include "field/terrain.h"
#include "field/vec.h"

namespace cydonia::render {

// The land's surface as POV-Ray draws it: heights rounded to 16 bits and squares split
// NW-SE. Copies of it, mirrored at its borders, continue it on all sides.
class Mesh {
  public:
    explicit Mesh(const Terrain& terrain);

    // The terrain with rounded heights, without masks.
    const Terrain& terrain() const { return terrain_; }
    // Whether a point is within this many copies of the land on each side.
    bool is_under(const Vec3& point, int lands) const;

    // A point of the mesh: its square and the position in it, the slopes of its triangle
    // (rise a cell, to the east and south), its height, and 1 or -1 for the mirroring of
    // the copy of the land along each axis.
    struct Spot {
        int i, j;
        double u, v;
        double east, south;
        double height;
        int mirrored_x, mirrored_y;
    };
    Spot spot(double east, double north) const;
    Vec3 face_normal(const Spot& spot) const;
    Vec3 smooth_normal(const Spot& spot) const;
    // The normal of the side wall of the land, or of a copy, at a point on it.
    Vec3 side_normal(const Vec3& point) const;
    // The corresponding point of the land, metres east and north.
    std::array<double, 2> on_land(double east, double north) const;

  private:
    Terrain terrain_;
};

}  // namespace cydonia::render
