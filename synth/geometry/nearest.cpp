#include "synth/geometry/nearest.h"

namespace cydonia::geometry {
namespace {

// The range of cells whose centres lie in [low, high], which are measured in cells from
// the first centre of a part.
void range(double low, double high, int count, int& first, int& end) {
    first = static_cast<int>(std::ceil(std::clamp(low, 0.0, double(count))));
    end = static_cast<int>(std::floor(std::clamp(high, -1.0, count - 1.0))) + 1;
}

// A line, with the values that are the same for every cell.
struct Line {
    Point2 a, d;
    double inverse;  // of its squared length
    std::int32_t segment;

    double squared(const Point2& p) const {
        const Point2 v = from_to(a, p);
        const double t = std::clamp(dot(v, d) * inverse, 0.0, 1.0);
        const double x = v[0] - t * d[0], y = v[1] - t * d[1];
        return x * x + y * y;
    }
};

void visit(const Line& line, const Grid& grid, const Grid::Range& cells, double squared,
           Field<Nearest>& field) {
    for (int j = cells.y0; j < cells.y1; ++j)
        for (int i = cells.x0; i < cells.x1; ++i) {
            const double here = line.squared(grid.centre(i, j));
            Nearest& nearest = field(i, j);
            if (here <= squared && here < nearest.squared) nearest = {here, line.segment};
        }
}

}  // namespace

Grid::Range Grid::cells_in(const Box& box) const {
    const Point2 first = centre(0, 0);
    Range cells;
    range((box.west - first[0]) / cell, (box.east - first[0]) / cell, width, cells.x0,
          cells.x1);
    range((first[1] - box.north) / cell, (first[1] - box.south) / cell, height, cells.y0,
          cells.y1);
    return cells;
}

double nearest_share(const Point2& a, const Point2& b, const Point2& p) {
    const Point2 d = from_to(a, b);
    return std::clamp(dot(from_to(a, p), d) * (1.0 / dot(d, d)), 0.0, 1.0);
}

void add_nearest(const Shape& shape, const Grid& grid, double reach,
                 Field<Nearest>& field) {
    // Slightly more than the reach, so that rounding leaves out no cell.
    const double margin = reach + 1e-6 * grid.cell;
    const Box part = grid.box().grown(margin);
    for (int s = 0; s < shape.segments(); ++s) {
        const Point2 &a = shape.points[s], &b = shape.points[s + 1];
        if (!Box::of(a, b).touches(part)) continue;
        const Point2 d = from_to(a, b);
        const Line line{a, d, 1.0 / dot(d, d), s};
        // Long lines are cut into pieces, as most of a slanted line's box is out of
        // reach.
        const double wanted =
            std::ceil(length(d) / std::max(4.0 * margin, 8.0 * grid.cell));
        const int pieces = static_cast<int>(std::clamp(wanted, 1.0, 65536.0));
        for (int k = 0; k < pieces; ++k) {
            const Box box = Box::of(between(a, b, double(k) / pieces),
                                    between(a, b, (k + 1.0) / pieces));
            const Grid::Range cells = grid.cells_in(box.grown(margin));
            if (!cells.empty()) visit(line, grid, cells, reach * reach, field);
        }
    }
}

}  // namespace cydonia::geometry
