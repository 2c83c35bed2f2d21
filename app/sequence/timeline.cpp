#include "app/sequence/timeline.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "render/cameras/path.h"

namespace cydonia {
namespace {

using render::CameraOptions;

bool is_path(const CameraOptions& camera) {
    return camera.kind == CameraOptions::Kind::kPath;
}

const CameraOptions& filming_one(const config::FramesSpec& frames,
                                 const std::vector<CameraOptions>& cameras) {
    const auto films = [&](const CameraOptions& camera) {
        return frames.camera.empty() ? is_path(camera) : camera.name == frames.camera;
    };
    const auto found = std::ranges::find_if(cameras, films);
    return found == cameras.end() ? cameras.front() : *found;
}

double last_key(const Clock& clock, const CameraOptions& camera) {
    const double of_path =
        is_path(camera) && !camera.keys.empty() ? camera.keys.back().frame : 0.0;
    return std::max(clock.last_key, of_path);
}

}  // namespace

Timeline timeline(const Clock& clock, const config::SceneSpec& first,
                  const std::vector<CameraOptions>& cameras) {
    const config::FramesSpec& frames = first.frames;
    const CameraOptions& films = filming_one(frames, cameras);
    if (!clock.varies && !is_path(films))
        throw bad_request(
            "nothing to film: no value of the scene has keys and camera '{}' is not on a "
            "path; give one keys, as in elevation = {{ keys = [[0, 8.0], [47, 40.0]] }}, "
            "or film a turntable",
            films.name);
    const double last = last_key(clock, films);
    const int needed = static_cast<int>(std::floor(std::min(
                           last, static_cast<double>(config::kMostFrames - 1)))) +
                       1;
    const int count = frames.count.value_or(needed);

    const auto index = static_cast<std::size_t>(&films - cameras.data());
    const bool from_scene = !first.render.cameras.empty() && clock.varies;
    const auto at = [&](double frame, const config::SceneSpec* then) {
        CameraOptions camera =
            from_scene && then ? then->render.cameras.at(index) : films;
        camera.frame = frame;
        return camera;
    };
    const auto scene_at = [&](double frame) {
        return clock.varies ? std::make_shared<const config::SceneSpec>(clock.at(frame))
                            : nullptr;
    };

    Timeline result;
    Sequence& sequence = result.sequence;
    sequence.name = name_of(Kind::kFilm);
    sequence.camera = films.name;
    sequence.exposed_by = every_tenth(static_cast<std::size_t>(count));
    sequence.rate = frames.rate;
    std::shared_ptr<const config::SceneSpec> now = scene_at(0.0);
    for (int i = 0; i < count; ++i) {
        auto next = scene_at(i + 1.0);
        SequenceFrame frame{at(i, now.get()), ""};
        frame.camera.name = frame_name(sequence.name, i);
        frame.next = at(i + 1.0, next.get());
        if (frame.camera.shutter_samples > 1)
            for (const double moment : render::shutter_times(frame.camera, i))
                frame.moments.push_back(at(moment, scene_at(moment).get()));
        frame.scene = std::move(now);
        now = std::move(next);
        sequence.frames.push_back(std::move(frame));
    }
    if (last > count - 1)
        result.messages.push_back(
            fmt::format("the keys go on to frame {:g}, the film ends at {}: frames.count "
                        "= {} has all",
                        last, count - 1, needed));
    return result;
}

}  // namespace cydonia
