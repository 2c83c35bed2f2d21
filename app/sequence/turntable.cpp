#include "app/sequence/turntable.h"

#include <algorithm>
#include <numbers>

#include "render/cameras/cameras.h"
#include "render/cameras/path.h"

namespace cydonia {
namespace {

using render::CameraOptions;

// A camera that sees the whole land, as one looks at a model on a table.
CameraOptions over_the_table(const std::vector<CameraOptions>& cameras) {
    CameraOptions camera;
    camera.name = "orbit";
    camera.kind = CameraOptions::Kind::kOrbit;
    camera.elevation = radians(32.0);
    camera.field_of_view = radians(40.0);
    camera.size = render::default_cameras().back().size;
    for (const CameraOptions& other : cameras)
        if (other.kind != CameraOptions::Kind::kOverhead) camera.size = other.size;
    return camera;
}

CameraOptions turning_camera(const config::FramesSpec& frames,
                             const std::vector<CameraOptions>& cameras) {
    const auto asked_for = [&](const CameraOptions& camera) {
        return camera.name == frames.camera && can_turn(camera);
    };
    const auto orbits = [](const CameraOptions& camera) {
        return camera.kind == CameraOptions::Kind::kOrbit;
    };
    if (const auto it = std::ranges::find_if(cameras, asked_for); it != cameras.end())
        return *it;
    if (const auto it = std::ranges::find_if(cameras, orbits); it != cameras.end())
        return *it;
    return over_the_table(cameras);
}

}  // namespace

Sequence turntable(const config::FramesSpec& frames,
                   const std::vector<CameraOptions>& cameras) {
    const CameraOptions camera = turning_camera(frames, cameras);
    const int count = frames.count.value_or(config::FramesSpec::kCount);
    const auto at = [&](double frame) {
        CameraOptions turned = camera;
        turned.turn = 2.0 * std::numbers::pi * frame / count;
        return turned;
    };

    Sequence sequence{.name = name_of(Kind::kTurntable),
                      .camera = camera.name,
                      .frames = {},
                      .exposed_by = every_tenth(static_cast<std::size_t>(count)),
                      .rate = frames.rate};
    for (int i = 0; i < count; ++i) {
        SequenceFrame frame{at(i), ""};
        frame.camera.name = frame_name(sequence.name, i);
        frame.next = at(i + 1);
        if (camera.shutter_samples > 1)
            for (const double moment : shutter_times(camera, i))
                frame.moments.push_back(at(moment));
        sequence.frames.push_back(std::move(frame));
    }
    return sequence;
}

}  // namespace cydonia
