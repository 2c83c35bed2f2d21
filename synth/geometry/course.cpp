#include "synth/geometry/course.h"

#include <optional>

#include "field/error.h"

namespace cydonia::geometry {
namespace {

constexpr double kMostSteps = 65536.0;

std::vector<Handle> sorted_handles(const Curve& curve, const std::string& name) {
    std::vector<Handle> handles = curve.handles;
    std::sort(handles.begin(), handles.end(),
              [](const Handle& a, const Handle& b) { return a.at < b.at; });
    for (std::size_t i = 0; i < handles.size(); ++i) {
        if (!(handles[i].at >= 0.0 && handles[i].at <= 1.0))
            throw bad_request("curve '{}': a handle is at {}: give a share from 0 to 1",
                              name, handles[i].at);
        if (i > 0 && handles[i].at - handles[i - 1].at < 1e-6)
            throw bad_request("curve '{}': two handles are at {}", name, handles[i].at);
    }
    return handles;
}

// The Hermite curve through the values that `value` finds in the handles. Where no handle
// has one, it is `otherwise` everywhere.
template <class Value>
Hermite through(const std::vector<Handle>& handles, double length, bool ring,
                double otherwise, const Value& value) {
    std::vector<Knot> knots;
    for (const Handle& handle : handles)
        if (const std::optional<double> v = value(handle))
            knots.push_back({handle.at * length, *v});
    // On a ring the end is also the beginning; the first handle there decides.
    if (ring && knots.size() > 1 &&
        knots.back().at - knots.front().at > (1.0 - 1e-6) * length)
        knots.pop_back();
    if (knots.empty()) knots.push_back({0.0, otherwise});
    return Hermite(std::move(knots), length, ring);
}

// The mean over each value and `half` values on either side; beyond the ends the
// outermost value is repeated.
std::vector<double> averaged(const std::vector<double>& values, int half, bool ring) {
    const int n = static_cast<int>(values.size());
    const auto value = [&](int i) {
        if (ring) return values[((i % (n - 1)) + n - 1) % (n - 1)];
        return values[std::clamp(i, 0, n - 1)];
    };
    double sum = 0.0;
    for (int i = -half; i <= half; ++i) sum += value(i);
    std::vector<double> mean(values.size());
    for (int i = 0; i < n; ++i) {
        mean[i] = sum / (2 * half + 1);
        sum += value(i + half + 1) - value(i - half);
    }
    return mean;
}

// The land's own height along the curve, without shapes smaller than the curve's area of
// effect. With them every stone would become a step in a road.
std::vector<double> natural_along(const Shape& shape, const Ground& ground,
                                  const HeightAt& natural, std::size_t count,
                                  double area) {
    std::vector<double> heights(count);
    const double step = shape.length() / double(count - 1);
    for (std::size_t i = 0; i < count; ++i) {
        const Point2 p = shape.at(double(i) * step);
        heights[i] = natural(std::clamp(p[0], 0.0, ground.width),
                             std::clamp(p[1], 0.0, ground.depth));
    }
    // Three box filters are nearly a Gaussian; here its standard deviation is half the
    // area.
    const double half = std::min(0.5 * area / step, 0.5 * double(count - 1));
    for (int pass = 0; pass < 3; ++pass)
        heights = averaged(heights, static_cast<int>(half), shape.closed);
    return heights;
}

}  // namespace

Course::Course(const Curve& curve, const std::string& name, const Shape& shape,
               const Ground& ground, const HeightAt& natural)
    : length_(shape.length()), ring_(shape.closed) {
    const std::vector<Handle> handles = sorted_handles(curve, name);
    const double steps = std::ceil(2.0 * length_ / ground.spacing);
    table_.resize(static_cast<std::size_t>(std::clamp(steps, 1.0, kMostSteps)) + 1);
    step_ = length_ / double(table_.size() - 1);
    tabulate(curve, handles, ground);

    double sum = 0.0;
    for (const Trait& trait : table_)
        for (double area : trait.area) {
            if (!(area >= 0.0))
                throw bad_request("curve '{}': its area is negative", name);
            largest_area_ = std::max(largest_area_, area);
            sum += area;
        }
    for (const Handle& handle : handles)
        if (handle.height) held_.push_back(handle.at * length_);
    if (!curve.relative) return;
    const double area = sum / (2.0 * double(table_.size()));
    const auto ground_heights =
        natural_along(shape, ground, natural, table_.size(), area);
    for (std::size_t i = 0; i < table_.size(); ++i) table_[i].height += ground_heights[i];
}

void Course::tabulate(const Curve& curve, const std::vector<Handle>& handles,
                      const Ground& ground) {
    const auto along = [&](double otherwise, const auto& value) {
        return through(handles, length_, ring_, otherwise, value);
    };
    const Hermite height =
        along(curve.height, [](const Handle& handle) { return handle.height; });
    for (std::size_t i = 0; i < table_.size(); ++i)
        table_[i].height = height(double(i) * step_);
    for (std::size_t side = 0; side < 2; ++side) {
        const Hermite gradient = along(curve.gradient[side], [&](const Handle& handle) {
            return handle.gradient ? std::optional((*handle.gradient)[side])
                                   : std::nullopt;
        });
        const Hermite area =
            along(curve.area[side].in(ground.width), [&](const Handle& handle) {
                return handle.area ? std::optional((*handle.area)[side].in(ground.width))
                                   : std::nullopt;
            });
        for (std::size_t i = 0; i < table_.size(); ++i) {
            table_[i].gradient[side] = gradient(double(i) * step_);
            table_[i].area[side] = area(double(i) * step_);
        }
    }
}

Trait Course::at(double along) const {
    const double place = std::clamp(along / step_, 0.0, double(table_.size() - 1));
    const std::size_t i = std::min(static_cast<std::size_t>(place), table_.size() - 2);
    const Trait &a = table_[i], &b = table_[i + 1];
    const double t = place - double(i);
    const auto mix = [t](double from, double to) { return from + t * (to - from); };
    return {mix(a.height, b.height),
            {mix(a.gradient[0], b.gradient[0]), mix(a.gradient[1], b.gradient[1])},
            {mix(a.area[0], b.area[0]), mix(a.area[1], b.area[1])}};
}

void Course::bend(const std::vector<Knot>& knots) {
    const Hermite added(knots, length_, ring_);
    for (std::size_t i = 0; i < table_.size(); ++i)
        table_[i].height += added(double(i) * step_);
}

bool Course::one_area() const {
    return std::all_of(table_.begin(), table_.end(), [&](const Trait& trait) {
        return std::min(trait.area[0], trait.area[1]) > (1.0 - 1e-9) * largest_area_;
    });
}

}  // namespace cydonia::geometry
