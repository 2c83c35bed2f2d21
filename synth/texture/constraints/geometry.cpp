#include "synth/texture/constraints/geometry.h"

#include "field/error.h"
#include "field/parallel.h"
#include "synth/geometry/nearest.h"
#include "synth/texture/constraints/junctions.h"
#include "synth/texture/constraints/sites.h"

namespace cydonia::texture {

using namespace geometry;

namespace {

constexpr int kBand = 16;       // rows at a time
constexpr double kLimit = 4.0;  // cells that a constraint reaches at any level
constexpr double kNear =
    1e-3;  // cells of level 0: a place nearer than that is on the constraint
constexpr double kMargin = 1e-6;  // cells, so that rounding leaves out no cell in reach
constexpr std::size_t kMostBends = 400'000;

PointConstraint point_constraint_of(const Point& point, const Ground& ground,
                                    const HeightAt& natural) {
    PointConstraint constraint{
        point.name,
        {point.at[0].in(ground.width), point.at[1].in(ground.depth)},
        point.height,
        point.gradient,
        point.radius.in(ground.width)};
    const Point2& at = constraint.at;
    if (!(std::abs(at[0]) < 1e9 && std::abs(at[1]) < 1e9))
        throw bad_request("point '{}' is a million kilometres away", point.name);
    if (!(constraint.radius >= 0.0))
        throw bad_request("point '{}': its radius is negative", point.name);
    if (point.relative)
        constraint.height += natural(std::clamp(at[0], 0.0, ground.width),
                                     std::clamp(at[1], 0.0, ground.depth));
    return constraint;
}

std::vector<CurveConstraint> curve_constraints_of(const Options& options,
                                                  const Ground& ground,
                                                  const HeightAt& natural) {
    std::vector<CurveConstraint> curves;
    std::size_t bends = 0;
    for (const Curve& curve : options.curves)
        for (NamedShape& named : shapes_of(curve, ground)) {
            bends += named.shape.points.size();
            if (bends > kMostBends)
                throw bad_request("the curves have more than {} bends: simplify them",
                                  kMostBends);
            Course course(curve, named.name, named.shape, ground, natural);
            curves.push_back({named.name, std::move(named.shape), std::move(course)});
        }
    parallel_for(static_cast<int>(curves.size()), [&](int i) {
        curves[i].area = SmoothArea(curves[i].shape, curves[i].course, ground);
    });
    return curves;
}

// The grid of a window's cells.
Grid grid_of(const Window& window, const Ground& ground) {
    const double cell = std::ldexp(ground.spacing, window.level);
    return {cell, 0.0, ground.depth, window.x, window.y, window.width, window.height};
}

// The sums of section 5.1 over constraints, for one cell.
struct Blend {
    double weights = 0.0, targets = 0.0, reaches = 0.0;
    double distance = std::numeric_limits<double>::infinity();

    // The weight is the inverse of the distance less that of the reach, so that it is 0
    // where the influence ends.
    void add(const Demand& asked, double reach, double nearest) {
        const double d = std::max(asked.distance, nearest);
        if (!(d < reach)) return;
        const double weight = 1.0 / d - 1.0 / reach;
        weights += weight;
        targets += weight * asked.target;
        reaches += weight * reach;
        distance = std::min(distance, asked.distance);
    }
    Pull pull() const {
        if (!(weights > 0.0)) return {};
        return {static_cast<float>(targets / weights), static_cast<float>(distance),
                static_cast<float>(reaches / weights)};
    }
};

// The blends of a few rows of a window.
class Band {
  public:
    Band(const Grid& grid, double nearest)
        : grid_(grid), nearest_(nearest), blends_(grid.width, grid.height) {}

    void add(const PointConstraint& point) {
        const double reach = std::min(point.radius, kLimit * grid_.cell);
        const Box box = Box::of(point.at, point.at).grown(reach + kMargin * grid_.cell);
        const auto cells = grid_.cells_in(box);
        for (int j = cells.y0; j < cells.y1; ++j)
            for (int i = cells.x0; i < cells.x1; ++i)
                blends_(i, j).add(point.asked(grid_.centre(i, j)), reach, nearest_);
    }

    void add(const CurveConstraint& curve, const Box& box) {
        const double limit = kLimit * grid_.cell;
        const double reach = std::min(curve.course.largest_area(), limit);
        const auto cells = grid_.cells_in(box.grown(reach + kMargin * grid_.cell));
        if (cells.empty() || !(reach > 0.0)) return;
        const Grid part{grid_.cell,         grid_.west,         grid_.north,
                        grid_.x + cells.x0, grid_.y + cells.y0, cells.x1 - cells.x0,
                        cells.y1 - cells.y0};
        Field<Nearest> nearest(part.width, part.height);
        add_nearest(curve.shape, part, reach, nearest);
        for (int j = 0; j < part.height; ++j)
            for (int i = 0; i < part.width; ++i) {
                const int segment = nearest(i, j).segment;
                if (segment < 0) continue;
                const Demand asked = demand_of(curve, segment, part.centre(i, j));
                blends_(cells.x0 + i, cells.y0 + j)
                    .add(asked, std::min(asked.area, limit), nearest_);
            }
    }

    void write(Field<Pull>& pulls, int first_row) const {
        for (int j = 0; j < grid_.height; ++j)
            for (int i = 0; i < grid_.width; ++i)
                pulls(i, first_row + j) = blends_(i, j).pull();
    }

  private:
    Grid grid_;
    double nearest_;
    Field<Blend> blends_;
};

}  // namespace

struct Geometry::Parts {
    Ground ground;
    std::vector<PointConstraint> points;
    std::vector<CurveConstraint> curves;
    std::vector<Box> boxes;  // of the curves
    std::vector<Site> sites;
    std::vector<std::string> names;

    bool touches(const Grid& grid) const {
        const Box box = grid.box().grown(kLimit * grid.cell);
        const auto near = [&](const Box& b) { return b.touches(box); };
        return std::any_of(boxes.begin(), boxes.end(), near) ||
               std::any_of(
                   points.begin(), points.end(),
                   [&](const PointConstraint& point) { return box.holds(point.at); });
    }
};

Geometry::Geometry(const Options& options, const Ground& ground, const HeightAt& natural,
                   Progress& progress)
    : parts_(std::make_unique<Parts>()) {
    parts_->ground = ground;
    for (const Point& point : options.points)
        parts_->points.push_back(point_constraint_of(point, ground, natural));
    parts_->curves = curve_constraints_of(options, ground, natural);
    join(parts_->points, parts_->curves, ground, progress);
    for (const PointConstraint& point : parts_->points)
        parts_->names.push_back(point.name);
    for (const CurveConstraint& curve : parts_->curves) {
        parts_->names.push_back(curve.name);
        parts_->boxes.push_back(curve.shape.box());
    }
    parts_->sites = sites_of(parts_->points, parts_->curves, ground, progress);
}

Geometry::~Geometry() = default;

bool Geometry::empty() const { return parts_->names.empty(); }

Field<Pull> Geometry::pulls(const Window& window) const {
    Field<Pull> pulls(window.width, window.height);
    const int bands = (window.height + kBand - 1) / kBand;
    parallel_for(bands, [&](int band) {
        Grid grid = grid_of(window, parts_->ground);
        grid.y += band * kBand;
        grid.height = std::min(kBand, window.height - band * kBand);
        if (grid.width < 1 || !parts_->touches(grid)) return;
        Band blends(grid, kNear * parts_->ground.spacing);
        for (const PointConstraint& point : parts_->points) blends.add(point);
        for (std::size_t s = 0; s < parts_->curves.size(); ++s)
            blends.add(parts_->curves[s], parts_->boxes[s]);
        blends.write(pulls, band * kBand);
    });
    return pulls;
}

const std::vector<Geometry::Site>& Geometry::sites() const { return parts_->sites; }
const std::vector<std::string>& Geometry::names() const { return parts_->names; }

}  // namespace cydonia::texture
