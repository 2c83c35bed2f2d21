#pragma once

#include <array>

#include "field/terrain.h"
#include "field/vec.h"

namespace cydonia::render {

// The land's surface between its samples as POV-Ray draws it: rounded heights, squares
// split NW-SE. It goes on around itself, mirrored at its borders.
class Mesh {
  public:
    explicit Mesh(const Terrain& terrain);

    // With rounded heights and no more.
    const Terrain& terrain() const { return terrain_; }
    // Over so many lands on each side of this one.
    bool is_under(const Vec3& point, int lands) const;

    // Where a place is: its square, how far in it, its triangle's slopes (rise a cell,
    // east and south), the height; and which way a copy of the land is mirrored, 1 or -1.
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
    // Of the side of this land or of a copy that the point is on.
    Vec3 side_normal(const Vec3& point) const;
    // Of this land, metres east and north, for a place on it or on a copy.
    std::array<double, 2> on_land(double east, double north) const;

  private:
    Terrain terrain_;
};

}  // namespace cydonia::render
