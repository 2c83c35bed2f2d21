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

// A silhouette as its camera saw it (section 3.1): the lines of sight to it, from which
// follows how high it stands over any place.
class Sight {
  public:
    // Says where the stroke folds back. Throws bad_request: no camera in the drawing,
    // nothing drawn, no width.
    Sight(const View& view, const std::string& name, Progress& progress);

    // Metres, where the line of sight passes over a place; none beside the stroke.
    std::optional<double> height_over(const Point2& place) const;
    // The same of a line below the stroke that has nothing narrower than so many metres
    // there; beside the stroke it goes on as at its ends. None behind the camera.
    std::optional<double> height_below(const Point2& place, double metres) const;

    // The lines of sight to the stroke's left and right end: a direction on the ground of
    // length 1, and metres that it rises a metre.
    struct Ray {
        Point2 direction;
        double rise;
    };
    std::array<Ray, 2> ends() const;
    Point2 eye() const { return {camera_.eye.x, camera_.eye.y}; }
    double eye_height() const { return camera_.eye.z; }

    // How far a landform's skyline is off the stroke, on average, pixels of a frame 1280
    // wide. `counts` tells the samples that belong to it; of those not what was seen
    // above the stroke before.
    double skyline_off(const Field<float>& land, const Field<float>& before,
                       double spacing, const std::vector<bool>& counts) const;

  private:
    // To the right of where the camera looks, radians; none behind it.
    std::optional<double> azimuth_of(const Point2& place) const;
    Ray ray_at(double azimuth, double rise) const;
    double row_of(double azimuth, double rise) const;  // pixels, upwards

    Camera camera_;
    Point2 ahead_, right_;  // on the ground
    double at(const Field<float>& line, double azimuth) const;

    Line line_;  // rise by azimuth
    // Below it, each without what is narrower than twice the one before.
    std::vector<Field<float>> below_;
};

// Where a line of sight ends: on the land, or, over all of it, on the wall that stands on
// the terrain's far edge. None where it does not come over the terrain.
struct Landing {
    Point2 place;
    double height;
    bool on_wall;
};
std::optional<Landing> landing_of(const Field<float>& land, double spacing,
                                  const Point2& eye, double eye_height,
                                  const Sight::Ray& ray);

// The part of a way that lies under the stroke; none without any.
std::optional<texture::Shape> part_in_sight(const texture::Shape& way, const Sight& sight,
                                            double step, const std::string& name);

}  // namespace cydonia::sketch
