#include "app/pipeline/frame.h"

#include "app/threads.h"
#include "render/cameras/cameras.h"
#include "render/cameras/view.h"
#include "render/scene/files.h"

namespace cydonia {
namespace {

// The camera's own sun, else the scene's, else the one whose shadows show the first image
// (a stage may have chosen its azimuth), else late afternoon.
Sun chosen_sun(const render::CameraOptions& camera, const render::Options& options,
               const Terrain& terrain) {
    if (camera.sun) return *camera.sun;
    if (options.sun) return *options.sun;
    if (!terrain.shadows.empty()) return terrain.shadows.front().sun;
    return {radians(315.0), radians(35.0)};
}

}  // namespace

FrameLand land_of_stills(const Job& job) {
    return {.key = job.land.drawn_key(), .site = [&job] {
                return std::make_shared<const Site>(
                    job.land.drawn(), [&job] { return job.land.maps(); },
                    job.folder / "pov");
            }};
}

Frame still_of(const Job& job, const render::CameraOptions& camera) {
    return {.camera = camera,
            .view = camera.name,
            .scene = job.spec,
            .land = land_of_stills(job),
            .threads = thread_count(),
            .progress = &job.progress};
}

std::vector<Frame> stills_of(const Job& job) {
    std::vector<Frame> stills;
    for (const render::CameraOptions& camera : job.cameras())
        stills.push_back(still_of(job, camera));
    return stills;
}

std::vector<render::CameraOptions> pictures_of(const Frame& frame) {
    if (frame.moments.empty()) return {frame.camera};
    std::vector<render::CameraOptions> pictures = frame.moments;
    for (std::size_t i = 0; i < pictures.size(); ++i)
        pictures[i].name =
            render::moment_name(frame.camera.name, static_cast<int>(i) + 1);
    return pictures;
}

void add_to(KeyBuilder& key, const Frame& frame) {
    key.add(frame.camera.name).add(frame.view);
    for (const render::CameraOptions& picture : pictures_of(frame)) {
        key.add(picture.size[0]).add(picture.size[1]).add(picture.frame);
        key.add(picture.turn).add(picture.sun.has_value());
        if (picture.sun) key.add(picture.sun->azimuth).add(picture.sun->elevation);
    }
}

render::Shot shot_of(const render::CameraOptions& camera, const config::SceneSpec& scene,
                     render::Quality quality, const Terrain& terrain) {
    const Camera view = render::place(camera, terrain, quality, scene.render.water);
    return {scene.title,
            camera.name,
            view,
            chosen_sun(camera, scene.render, terrain),
            scene.render,
            quality,
            render::around_of(terrain, scene.render),
            render::is_smooth(view, terrain)};
}

}  // namespace cydonia
