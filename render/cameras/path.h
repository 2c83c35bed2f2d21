#pragma once

#include <vector>

#include "field/vec.h"
#include "render/cameras/options.h"

namespace cydonia::render {

// A curve through points at given times. Its shape is the centripetal Catmull-Rom curve
// (Catmull and Rom 1974; Yuksel, Schaefer and Keyser 2011: no cusp and no loop between
// two points). Its pace is a monotone cubic (Fritsch and Butland 1984): the motion never
// turns back, its speed has no jumps, and a point given twice in a row is a rest.
class TimedCurve {
  public:
    // There are as many times as points, at least one, and times rise. With `eased` the
    // speed is zero at both ends.
    TimedCurve(std::vector<double> times, const std::vector<Vec3>& points, bool eased);

    Vec3 operator()(double time)
        const;  // the first point before the first time, the last point after

  private:
    Vec3 shape_at(double knot) const;

    std::vector<double> times_, way_, pace_;  // of every point: its knot, knots a frame
    std::vector<double> knots_;               // of points that differ from the one before
    std::vector<Vec3> points_, tangents_;     // at the knots
};

// The times, in frames, of a camera's shutter samples. They are spread evenly over the
// time that the shutter is open, which is centred on `frame`. The mean of their pictures,
// in linear light, is the frame.
std::vector<double> shutter_times(const CameraOptions& options, double frame);

}  // namespace cydonia::render
