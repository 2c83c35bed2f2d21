#pragma once

#include <cstdint>
#include <limits>

#include "field/field.h"
#include "synth/geometry/shape.h"

namespace cydonia::texture {

// Cells of a grid on the plane: numbers of its own, which do not depend on the part of it
// that is looked at.
struct Grid {
    double cell = 1.0;                        // metres
    double west = 0.0, north = 0.0;           // of the corner of cell (0, 0)
    int x = 0, y = 0, width = 0, height = 0;  // the part

    Point2 centre(int i, int j) const {  // of a cell of the part
        return {west + (x + i + 0.5) * cell, north - (y + j + 0.5) * cell};
    }
    Box box() const {  // between outer centres
        return Box::of(centre(0, 0), centre(width - 1, height - 1));
    }
    // A range of the part's columns and rows.
    struct Range {
        int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // without the last
        bool empty() const { return x0 >= x1 || y0 >= y1; }
    };
    Range cells_in(const Box& box) const;
};

// The line of a shape that is nearest to a cell.
struct Nearest {
    double squared = std::numeric_limits<double>::infinity();  // metres squared
    std::int32_t segment = -1;
};

// The point of a line that is nearest to p, as a share of it.
double nearest_share(const Point2& a, const Point2& b, const Point2& p);

// Distance field of a shape where it is nearer than `reach`; elsewhere what `field` holds
// (one cell each of the grid's part). Visits the band along the shape only.
void add_nearest(const Shape& shape, const Grid& grid, double reach,
                 Field<Nearest>& field);

}  // namespace cydonia::texture
