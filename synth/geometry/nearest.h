#pragma once

#include <cstdint>
#include <limits>

#include "field/field.h"
#include "synth/geometry/shape.h"

namespace cydonia::geometry {

// A part of a grid of cells on the ground. Cells have the same numbers whichever part is
// looked at.
struct Grid {
    double cell = 1.0;                        // metres
    double west = 0.0, north = 0.0;           // of the corner of cell (0, 0)
    int x = 0, y = 0, width = 0, height = 0;  // the part, cells

    Point2 centre(int i, int j) const {  // of cell (i, j) of the part
        return {west + (x + i + 0.5) * cell, north - (y + j + 0.5) * cell};
    }
    Box box() const {  // around the outermost centres
        return Box::of(centre(0, 0), centre(width - 1, height - 1));
    }
    // A range of the part's columns and rows.
    struct Range {
        int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // x1 and y1 are one beyond
        bool empty() const { return x0 >= x1 || y0 >= y1; }
    };
    Range cells_in(const Box& box) const;
};

// The line of a shape that is nearest to a cell; segment -1: none is in reach.
struct Nearest {
    double squared = std::numeric_limits<double>::infinity();  // metres squared
    std::int32_t segment = -1;
};

// The point of the line from a to b that is nearest to p, as a share of the line.
double nearest_share(const Point2& a, const Point2& b, const Point2& p);

// Writes the distance field of a shape into `field`, which has a value for each cell of
// the grid's part, wherever the shape is nearer than `reach` metres and than what stands
// there. Only the band along the shape is visited.
void add_nearest(const Shape& shape, const Grid& grid, double reach,
                 Field<Nearest>& field);

}  // namespace cydonia::geometry
