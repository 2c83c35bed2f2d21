#include "synth/texture/constraints/area.h"

#include "field/sample.h"
#include "synth/texture/constraints/curve_constraint.h"

namespace cydonia::texture {

using namespace geometry;

namespace {

constexpr double kNodes = 256.0;  // nodes along a side, at most
// Half the side of each of the two square averages, as a share of the distance to the
// curve. The corners of both together stay on one side of the curve.
constexpr double kBlur = 0.28;

// Sums of a field over rectangles, whose sides may cut cells.
class Sums {
  public:
    template <class Value>
    Sums(int width, int height, const Value& value) : sums_(width + 1, height + 1, 0.0) {
        for (int y = 0; y < height; ++y) {
            double row = 0.0;
            for (int x = 0; x < width; ++x) {
                row += value(x, y);
                sums_(x + 1, y + 1) = sums_(x + 1, y) + row;
            }
        }
    }
    // The sum over [x0, x1] x [y0, y1], where a cell is 1 wide.
    double over(double x0, double y0, double x1, double y1) const {
        return below(x1, y1) - below(x0, y1) - below(x1, y0) + below(x0, y0);
    }

  private:
    double below(double x, double y) const {
        x = std::clamp(x, 0.0, sums_.width() - 1.0);
        y = std::clamp(y, 0.0, sums_.height() - 1.0);
        const int i = std::min(int(x), sums_.width() - 2);
        const int j = std::min(int(y), sums_.height() - 2);
        const double u = x - i, v = y - j;
        return (1 - v) * ((1 - u) * sums_(i, j) + u * sums_(i + 1, j)) +
               v * ((1 - u) * sums_(i, j + 1) + u * sums_(i + 1, j + 1));
    }
    Field<double> sums_;
};

// For each cell the mean of those cells within kBlur times its distance that have an
// area.
Field<float> averaged(const Field<float>& areas, const Field<float>& distances) {
    const int width = areas.width(), height = areas.height();
    const auto known = [&](int x, int y) { return distances(x, y) >= 0.0f; };
    const Sums sums(width, height,
                    [&](int x, int y) { return known(x, y) ? areas(x, y) : 0.0f; });
    const Sums counts(width, height,
                      [&](int x, int y) { return known(x, y) ? 1.0 : 0.0; });
    Field<float> mean = areas;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double r = kBlur * distances(x, y);
            if (r <= 0.5) continue;  // less than its cell
            const double x0 = x + 0.5 - r, x1 = x + 0.5 + r;
            const double y0 = y + 0.5 - r, y1 = y + 0.5 + r;
            mean(x, y) = static_cast<float>(sums.over(x0, y0, x1, y1) /
                                            counts.over(x0, y0, x1, y1));
        }
    return mean;
}

}  // namespace

SmoothArea::SmoothArea(const Shape& shape, const Course& course, const Ground& ground) {
    const double area = course.largest_area(), reach = 1.5 * area;
    if (course.one_area() || !(area > 0.0)) return;
    const Box land = Box{0.0, ground.width, 0.0, ground.depth}.grown(reach);
    if (!shape.box().touches(land)) return;
    const Box box = shape.box().grown(reach).within(land);
    const double width = box.east - box.west, depth = box.north - box.south;
    const double node =
        std::max({ground.spacing, area / 10.0, std::max(width, depth) / kNodes});
    grid_ = {
        node, box.west, box.north, 0, 0, 1 + int(width / node), 1 + int(depth / node)};

    Field<Nearest> nearest(grid_.width, grid_.height);
    add_nearest(shape, grid_, reach, nearest);
    areas_ = Field<float>(grid_.width, grid_.height, 0.0f);
    Field<float> distances(grid_.width, grid_.height, -1.0f);  // nodes; unknown
    for (int y = 0; y < grid_.height; ++y)
        for (int x = 0; x < grid_.width; ++x) {
            const int segment = nearest(x, y).segment;
            if (segment < 0) continue;
            const Demand asked = demand_of(shape, course, segment, grid_.centre(x, y));
            areas_(x, y) = static_cast<float>(asked.area);
            distances(x, y) = static_cast<float>(asked.distance / node);
        }
    for (int pass = 0; pass < 2; ++pass) areas_ = averaged(areas_, distances);
}

double SmoothArea::at(const Point2& p, double distance, double own) const {
    if (areas_.empty()) return own;
    // Close to the curve the nodes around p may lie on its other side.
    const double u = std::clamp(distance / grid_.cell / 1.5 - 1.0, 0.0, 1.0);
    if (u == 0.0) return own;
    const Point2 first = grid_.centre(0, 0);
    const double smooth =
        bilinear(areas_, (p[0] - first[0]) / grid_.cell, (first[1] - p[1]) / grid_.cell);
    return own + u * u * (3.0 - 2.0 * u) * (smooth - own);
}

}  // namespace cydonia::texture
