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
    texture::Ground ground;

    double at(double east, double north) const {
        return bilinear(heights, east / ground.spacing - 0.5,
                        heights.height() - north / ground.spacing - 0.5);
    }
    // Whether a way that ends there is pinned to the terrain's side.
    bool is_edge(const Point2& p) const {
        const double margin = ground.spacing;
        return p[0] < margin || p[1] < margin || p[0] > ground.width - margin ||
               p[1] > ground.depth - margin;
    }
    double along(const texture::Shape& shape, int i, int values) const {
        const Point2 p = shape.at(shape.length() * i / (values - 1));
        return at(p[0], p[1]);
    }
};

// How many values a line so long has: one a sample.
int values_along(double length, double spacing);

bool has_way(const Feature& feature);
// Without their loops, which are said.
std::vector<texture::NamedShape> ways_of(const std::string& name, const Way& way,
                                         const Land& land, Progress& progress);

// What the landforms of one feature are made with.
struct Plan {
    std::vector<texture::NamedShape> ways;
    std::vector<Landform> landforms;
    std::optional<Sight> sight;
};

// On the land so far; a stroke in a view that has no way of its own is cast on
// `seen_through`. Says what is repaired. Throws bad_request, naming the curve.
Plan plan_of(const Feature& feature, const Land& land, const Field<float>& seen_through,
             const Options& options, Progress& progress);

}  // namespace cydonia::sketch
