// Seconds of the passes of a frame of 1920x1080 over 1024x1024 samples, asked: 3;
// and of a preview of 960x540, asked: 1.
#include <fmt/core.h>

#include <cmath>

#include "bench/measure.h"
#include "render/cameras/cameras.h"
#include "render/embree/preview_frame.h"
#include "render/frames/frame.h"
#include "render/ground/ground.h"
#include "render/passes/passes.h"
#include "tests/render/shadow_land.h"

int main() try {
    using namespace cydonia;
    using namespace cydonia::render;
    Terrain land;
    land.spacing = 10.0;
    land.heights = fractal(1024, 1024, 600.0f, 1);
    const CameraOptions options = default_cameras().back();
    const Camera camera = place(options, land, Quality::kFinal);
    PassMaps maps{Field<std::uint8_t>(1024, 1024, 1), Field<std::uint8_t>(1024, 1024, 2),
                  Field<float>(1024, 1024, 0.9f)};
    const Field<Rgb> beauty(camera.width, camera.height, Rgb{0.2f, 0.3f, 0.1f});

    const bench::Stopwatch all;
    const View view(land, {.around = Around::kLand});
    const double built = all.seconds();
    const Field<SeenPoint> points = view.seen(CameraRays(camera), true);
    const double seen = all.seconds();
    const auto layers =
        passes(view, points, {radians(315.0), radians(25.0)}, maps, values_in(kPasses));
    const double filled = all.seconds();
    const bench::ScratchFolder folder;
    write_passes(folder.path() / "a.exr", beauty, layers, camera.width, camera.height,
                 {});
    const double written = all.seconds();
    fmt::print(
        "passes {}x{}: mesh {:.2f} s, rays {:.2f} s, layers {:.2f} s, file {:.2f} s; "
        "together {:.2f} s, asked 3; peak {:.0f} MiB\n",
        camera.width, camera.height, built, seen - built, filled - seen, written - filled,
        written, bench::peak_mebibytes());

    Shot shot;
    shot.around = Around::kLand;
    shot.sun = {radians(315.0), radians(25.0)};
    CameraOptions small = options;
    small.size = {960, 540};
    shot.camera = place(small, land, Quality::kFinal);
    const bench::Stopwatch preview;
    picture_of(preview_frame(shot, land), shot.options.colour);
    fmt::print("preview {}x{}: {:.2f} s, asked 1\n", shot.camera.width,
               shot.camera.height, preview.seconds());
} catch (const cydonia::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(error.code());
}
