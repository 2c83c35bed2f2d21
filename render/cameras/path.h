#pragma once

#include <vector>

#include "field/vec.h"
#include "render/cameras/options.h"

namespace cydonia::render {

// A way through points at given times. Its shape is the centripetal Catmull-Rom curve
// (Catmull and Rom 1974; Yuksel, Schaefer and Keyser 2011: no cusp and no loop between
// two points), its pace a monotone cubic (Fritsch and Butland 1984), so that it never
// turns back and speed has no jumps; points given twice in a row are a rest.
class TimedCurve {
  public:
    // As many times as points, at least one, times rising. `eased`: speed is zero at both
    // ends.
    TimedCurve(std::vector<double> times, const std::vector<Vec3>& points, bool eased);

    Vec3 operator()(double time) const;  // before and after: the first point, the last

  private:
    Vec3 shape_at(double knot) const;

    std::vector<double> times_, way_, pace_;  // of every point: its knot, knots a frame
    std::vector<double> knots_;               // of points that differ from the one before
    std::vector<Vec3> points_, tangents_;     // at the knots
};

// The moments of a frame at which a camera's shutter samples are taken, evenly over the
// time it is open, its middle at `frame`. Their pictures' mean, of linear light, is the
// frame.
std::vector<double> shutter_times(const CameraOptions& options, double frame);

}  // namespace cydonia::render
