#pragma once

#include <optional>
#include <string>
#include <vector>

#include "field/field.h"
#include "field/progress.h"
#include "field/sample.h"
#include "synth/geometry/ground.h"
#include "synth/sketch/footprint.h"
#include "synth/sketch/options.h"
#include "synth/sketch/sight.h"

namespace cydonia::sketch {

struct Land {
    Field<float> heights;
    geometry::Ground ground;

    double at(double east, double north) const {
        return bilinear(heights, east / ground.spacing - 0.5,
                        heights.height() - north / ground.spacing - 0.5);
    }
    // Whether a way that ends there ends at the terrain's side.
    bool is_edge(const Point2& p) const {
        const double margin = ground.spacing;
        return p[0] < margin || p[1] < margin || p[0] > ground.width - margin ||
               p[1] > ground.depth - margin;
    }
    double along(const geometry::Shape& shape, int i, int values) const {
        const Point2 p = shape.at(shape.length() * i / (values - 1));
        return at(p[0], p[1]);
    }
};

// The number of values of a line so long: one for each sample.
int values_along(double length, double spacing);

bool has_way(const Feature& feature);
// The shapes of a way without loops. A note says where loops were cut off.
std::vector<geometry::NamedShape> ways_of(const std::string& name, const Way& way,
                                          const Land& land, Progress& progress);

// Everything that the landforms of one feature are made from.
struct Plan {
    std::vector<geometry::NamedShape> ways;
    std::vector<Landform> landforms;
    std::optional<Sight> sight;
};

// The plan of a feature on the land so far. A stroke in a view that has no way of its own
// is cast on `seen_through`. Says what was repaired. Throws bad_request, which names the
// curve.
Plan plan_of(const Feature& feature, const Land& land, const Field<float>& seen_through,
             const Options& options, Progress& progress);

}  // namespace cydonia::sketch
