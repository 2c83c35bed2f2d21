#include "synth/texture/constraints/constraint_errors.h"

#include <algorithm>
#include <cmath>

#include "field/sample.h"

namespace cydonia::texture {
namespace {

// Until the end rms holds the sum of the squared errors.
void add(ConstraintError& sum, double error) {
    sum.max = std::max(sum.max, std::abs(error));
    sum.rms += error * error;
    ++sum.sites;
}

void finish(ConstraintError& sum) {
    if (sum.sites > 0) sum.rms = std::sqrt(sum.rms / sum.sites);
}

}  // namespace

ConstraintErrors constraint_errors(const Geometry& geometry, const Field<float>& heights,
                                   double spacing) {
    ConstraintErrors errors;
    for (const std::string& name : geometry.names()) errors.each.push_back({name});
    if (heights.empty()) return errors;
    const double depth = heights.height() * spacing;
    for (const Geometry::Site& site : geometry.sites()) {
        const double height =
            bilinear(heights, site.x / spacing - 0.5, (depth - site.y) / spacing - 0.5);
        add(errors.each[static_cast<std::size_t>(site.constraint)], height - site.height);
        add(errors.all, height - site.height);
    }
    for (ConstraintError& error : errors.each) finish(error);
    finish(errors.all);
    return errors;
}

}  // namespace cydonia::texture
