#pragma once

#include <optional>
#include <string>

#include "field/camera.h"
#include "field/field.h"
#include "field/progress.h"
#include "synth/geometry/shape.h"
#include "synth/sketch/options.h"
#include "synth/sketch/stroke.h"

namespace cydonia::sketch {

// A silhouette as its camera saw it (section 3.1): the lines of sight to it, which give
// its height above any position.
class Sight {
  public:
    // Says where the stroke folds back. Throws bad_request for a drawing without a camera
    // and a stroke that is empty or has no width.
    Sight(const View& view, const std::string& name, Progress& progress);

    // The height in metres at which the line of sight passes over a position; none beside
    // the stroke.
    std::optional<double> height_over(const Point2& place) const;
    // The same for a line below the stroke that has nothing narrower than so many metres
    // there. Beside the stroke it continues level. None behind the camera.
    std::optional<double> height_below(const Point2& place, double metres) const;

    // The lines of sight to the stroke's left and right end: a direction of length 1 on
    // the ground, and its rise over run.
    struct Ray {
        Point2 direction;
        double rise;
    };
    std::array<Ray, 2> ends() const;
    Point2 eye() const { return {camera_.eye.x, camera_.eye.y}; }
    double eye_height() const { return camera_.eye.z; }

    // The mean distance of a landform's skyline from the stroke, in pixels of a frame
    // 1280 wide. `counts` tells which samples belong to the landform; those that were
    // visible above the stroke before do not count.
    double skyline_off(const Field<float>& land, const Field<float>& before,
                       double spacing, const std::vector<bool>& counts) const;

  private:
    // The angle to the right of the camera's direction, radians; none behind the camera.
    std::optional<double> azimuth_of(const Point2& place) const;
    Ray ray_at(double azimuth, double rise) const;
    double row_of(double azimuth, double rise) const;  // pixels, upwards

    Camera camera_;
    Point2 ahead_, right_;  // on the ground
    double at(const Field<float>& line, double azimuth) const;

    Line line_;  // rise by azimuth
    // Lines below it, each of which has nothing narrower than twice the limit of the one
    // before.
    std::vector<Field<float>> below_;
};

// Where a line of sight ends: on the land, or, if it passes over all of it, on a wall at
// the terrain's far edge. None where it does not pass over the terrain.
struct Landing {
    Point2 place;
    double height;
    bool on_wall;
};
std::optional<Landing> landing_of(const Field<float>& land, double spacing,
                                  const Point2& eye, double eye_height,
                                  const Sight::Ray& ray);

// The part of a way that lies under the stroke, if there is any.
std::optional<geometry::Shape> part_in_sight(const geometry::Shape& way,
                                             const Sight& sight, double step,
                                             const std::string& name);

}  // namespace cydonia::sketch
