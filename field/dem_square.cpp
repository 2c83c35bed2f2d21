#include <gdalwarper.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "field/dem_grid.h"
#include "field/error.h"
#include "field/gdal.h"

namespace cydonia {
namespace {

constexpr double kWidestDegrees = 20.0;  // beyond, no plane fits the ground within 2%

struct Point {
    double x, y;
};

struct FreeTransformation {
    void operator()(OGRCoordinateTransformation* t) const {
        OGRCoordinateTransformation::DestroyCT(t);
    }
};
using Transformation = std::unique_ptr<OGRCoordinateTransformation, FreeTransformation>;

Transformation transformation(const OGRSpatialReference& from,
                              const OGRSpatialReference& to) {
    Transformation result(OGRCreateCoordinateTransformation(&from, &to));
    if (!result)
        throw bad_request("its coordinate system is not understood: {}",
                          QuietGdal::message());
    return result;
}

Point moved(OGRCoordinateTransformation& transformation, Point p) {
    if (!transformation.Transform(1, &p.x, &p.y) || !std::isfinite(p.x + p.y))
        throw bad_request("its corners are nowhere on the ground: {}",
                          QuietGdal::message());
    return p;
}

// The coordinates of a point given in columns and rows.
Point place(const DemGrid& grid, double column, double row) {
    const auto& t = grid.transform;
    return {t[0] + column * t[1], t[3] + row * t[5]};
}

Point middle(const DemGrid& grid) {
    return place(grid, 0.5 * grid.heights.width(), 0.5 * grid.heights.height());
}

// A transverse Mercator projection whose meridian and origin lie in the grid's middle,
// where it is true to scale. It uses the body that the file names, be it Mars or the
// Earth.
OGRSpatialReference ground_plane(const DemGrid& grid) {
    const std::unique_ptr<OGRSpatialReference> degrees(grid.plane.CloneGeogCS());
    if (!degrees) throw bad_request("its coordinate system names no ellipsoid");
    degrees->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const Point at = moved(*transformation(grid.plane, *degrees), middle(grid));

    OGRSpatialReference ground;
    ground.SetProjCS("middle of the model");
    ground.CopyGeogCSFrom(degrees.get());
    ground.SetTM(at.y, at.x, 1.0, 0.0, 0.0);
    ground.SetLinearUnits("metre", 1.0);
    ground.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return ground;
}

struct CellSize {
    double east, north;  // metres
};

CellSize on_the_ground(const DemGrid& grid, const OGRSpatialReference& ground) {
    const auto to_ground = transformation(grid.plane, ground);
    const double column = 0.5 * grid.heights.width(), row = 0.5 * grid.heights.height();
    const auto step = [&](double dx, double dy) {
        const Point a = moved(*to_ground, place(grid, column - dx, row - dy));
        const Point b = moved(*to_ground, place(grid, column + dx, row + dy));
        return std::hypot(b.x - a.x, b.y - a.y);
    };
    return {step(0.5, 0.0), step(0.0, 0.5)};
}

struct Rectangle {
    double west, south, east, north;
};

// The largest upright rectangle of another plane that the grid covers completely.
Rectangle covered(const DemGrid& grid, OGRCoordinateTransformation* to_plane) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    constexpr int kSteps = 64;  // along each edge
    const double columns = grid.heights.width(), rows = grid.heights.height();
    const auto at = [&](double column, double row) {
        const Point p = place(grid, column, row);
        return to_plane ? moved(*to_plane, p) : p;
    };
    Rectangle inside{-kInfinity, -kInfinity, kInfinity, kInfinity};
    for (int i = 0; i <= kSteps; ++i) {
        const double column = columns * i / kSteps, row = rows * i / kSteps;
        inside.west = std::max(inside.west, at(0.0, row).x);
        inside.east = std::min(inside.east, at(columns, row).x);
        inside.north = std::min(inside.north, at(column, 0.0).y);
        inside.south = std::max(inside.south, at(column, rows).y);
    }
    return inside;
}

Dataset dataset_of(const Field<float>& heights, const std::array<double, 6>& transform,
                   const OGRSpatialReference& plane) {
    Dataset dataset = memory_dataset(heights.width(), heights.height(), GDT_Float32);
    std::array<double, 6> copy = transform;
    dataset->SetGeoTransform(copy.data());
    if (!plane.IsEmpty()) dataset->SetSpatialRef(&plane);
    store(heights, *dataset);
    return dataset;
}

// The cells of `spacing` (units of `plane`) that fit into the rectangle. What is left
// over is divided between opposite edges.
Field<float> warped(const DemGrid& grid, const OGRSpatialReference& plane, Rectangle box,
                    double spacing) {
    const double columns = std::floor((box.east - box.west) / spacing + 1e-6);
    const double rows = std::floor((box.north - box.south) / spacing + 1e-6);
    if (!(columns >= 2.0 && rows >= 2.0))
        throw bad_request("no two by two square cells fit into it");
    if (columns > kLargestSide || rows > kLargestSide)
        throw bad_request("{:.0f} x {:.0f} square cells, more than {} x {}", columns,
                          rows, kLargestSide, kLargestSide);

    Field<float> heights(static_cast<int>(columns), static_cast<int>(rows),
                         std::numeric_limits<float>::quiet_NaN());
    const double west = 0.5 * (box.west + box.east - columns * spacing);
    const double north = 0.5 * (box.north + box.south + rows * spacing);
    const Dataset from = dataset_of(grid.heights, grid.transform, grid.plane);
    const Dataset to =
        dataset_of(heights, {west, spacing, 0.0, north, 0.0, -spacing}, plane);
    constexpr double kCellsOff = 0.05;  // of where a sample is taken
    if (GDALReprojectImage(from.get(), nullptr, to.get(), nullptr, GRA_Cubic, 0.0,
                           kCellsOff, nullptr, nullptr, nullptr) != CE_None)
        throw bad_request("it cannot be resampled: {}", QuietGdal::message());
    load(*to, heights);
    return heights;
}

bool nearly(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

void refuse_too_wide(const DemGrid& grid) {
    const double wide = grid.transform[1] * grid.heights.width();
    const double tall = -grid.transform[5] * grid.heights.height();
    if (grid.plane.IsGeographic() && std::max(wide, tall) > kWidestDegrees)
        throw bad_request("it spans {:.3g} x {:.3g} degrees; cut out at most {:g}", wide,
                          tall, kWidestDegrees);
}

Terrain land(Field<float> heights, double spacing) {
    Terrain terrain;
    terrain.heights = std::move(heights);
    terrain.spacing = spacing;
    return terrain;
}

Terrain on_its_plane(const DemGrid& grid, double unit, Notes& notes) {
    const double east = grid.transform[1], north = -grid.transform[5];
    if (nearly(east, north, 1e-3)) return land(grid.heights, unit * east);
    const double spacing = std::sqrt(east * north);
    notes.push_back(
        fmt::format("cells of {:.4g} x {:.4g} m were resampled to squares of {:.4g} m",
                    unit * east, unit * north, unit * spacing));
    return land(warped(grid, grid.plane, covered(grid, nullptr), spacing),
                unit * spacing);
}

}  // namespace

Terrain on_square_metres(const DemGrid& grid, Notes& notes) {
    const bool has_ground = grid.plane.IsGeographic() || grid.plane.IsProjected();
    const double unit = grid.plane.IsEmpty() ? 1.0 : grid.plane.GetLinearUnits();
    if (!has_ground) return on_its_plane(grid, unit, notes);

    refuse_too_wide(grid);
    const OGRSpatialReference ground = ground_plane(grid);
    const CellSize cell = on_the_ground(grid, ground);
    if (grid.plane.IsProjected() && nearly(cell.east, unit * grid.transform[1], 0.01) &&
        nearly(cell.north, -unit * grid.transform[5], 0.01))
        return on_its_plane(grid, unit, notes);

    const double spacing = std::sqrt(cell.east * cell.north);
    const auto to_ground = transformation(grid.plane, ground);
    notes.push_back(fmt::format(
        "cells of {:.4g} x {:.4g} m on the ground were warped to squares of {:.4g} m",
        cell.east, cell.north, spacing));
    return land(warped(grid, ground, covered(grid, to_ground.get()), spacing), spacing);
}

}  // namespace cydonia
