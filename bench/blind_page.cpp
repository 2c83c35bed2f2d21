#include "bench/blind_page.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <thread>

#include "bench/measure.h"
#include "field/progress.h"
#include "field/svg.h"
#include "render/cameras/cameras.h"
#include "render/frames/frame.h"
#include "render/frames/povray.h"
#include "render/pov/scene.h"

namespace cydonia::bench {

namespace {

// Pixels. Frames are traced twice as large, for their edges' sake.
constexpr int kWidth = 760, kHeight = 500;
constexpr int kGap = 12, kCaption = 40;
constexpr auto kTimeLimit = std::chrono::minutes(10);

render::CameraOptions camera_of(const char* name, const View& view) {
    render::CameraOptions camera;
    camera.name = name;
    camera.azimuth = view.azimuth;
    camera.size = {2 * 3 * kWidth, 2 * 3 * kHeight};  // a draft is a third as large
    camera.sun =
        Sun{std::fmod(view.azimuth + radians(view.sun_on_the_left ? 80.0 : 280.0),
                      radians(360.0)),
            radians(38.0)};
    return camera;
}

render::CameraOptions from_above(const View& view) {
    render::CameraOptions camera = camera_of("above", view);
    camera.kind = render::CameraOptions::Kind::kOrbit;
    camera.elevation = radians(52.0);
    camera.distance = of_width(1.9);
    camera.field_of_view = radians(38.0);
    return camera;
}

// Over the nearer part of the land, towards its middle.
render::CameraOptions close_up(const View& view) {
    render::CameraOptions camera = camera_of("near", view);
    camera.kind = render::CameraOptions::Kind::kLookAt;
    const double east = std::sin(view.azimuth), north = std::cos(view.azimuth);
    camera.eye = {of_width(0.5 + 0.28 * east), of_width(0.5 + 0.28 * north),
                  of_width(0.06)};
    camera.target = {of_width(0.5), of_width(0.5), of_width(0.0)};
    camera.field_of_view = radians(42.0);
    return camera;
}

Field<Rgb8> halved(const Field<Rgba8>& picture) {
    Field<Rgb8> result(picture.width() / 2, picture.height() / 2);
    for (int y = 0; y < result.height(); ++y)
        for (int x = 0; x < result.width(); ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                int sum = 2;
                for (int i = 0; i < 4; ++i)
                    sum += picture(2 * x + i % 2, 2 * y + i / 2)[c];
                result(x, y)[c] = static_cast<std::uint8_t>(sum / 4);
            }
    return result;
}

Field<Rgb8> frame(const std::filesystem::path& folder, const Terrain& land,
                  const render::CameraOptions& camera, const render::Options& options) {
    constexpr auto kDraft = render::Quality::kDraft;
    render::write_pov_scene(
        folder,
        {camera.name, camera.name, render::place(camera, land, kDraft), *camera.sun,
         options, kDraft},
        land);
    SilentProgress silent;
    render::run_povray(
        folder, camera.name,
        static_cast<int>(std::max(1u, std::thread::hardware_concurrency())), kTimeLimit,
        silent);
    render::deliver_frame(folder / (camera.name + ".exr"), folder / "frames", camera.name,
                          options.colour, {});
    return halved(read_rgba(open_source(folder / "frames" / (camera.name + ".png"))));
}

void lay(const Field<Rgb8>& picture, int x, int y, Field<Rgb8>& page) {
    for (int row = 0; row < picture.height(); ++row)
        std::ranges::copy(picture.row(row), page.row(y + row).begin() + x);
}

// Above and close up, one over the other.
void lay_land(const Terrain& land, const View& view, int x, Field<Rgb8>& page) {
    const ScratchFolder scratch;
    std::filesystem::create_directory(scratch.path() / "frames");
    const render::Options options;
    render::write_pov_assets(
        scratch.path(), land,
        render::land_maps(land, options.ground, render::Quality::kDraft));
    lay(frame(scratch.path(), land, from_above(view), options), x, kCaption, page);
    lay(frame(scratch.path(), land, close_up(view), options), x,
        kCaption + kHeight + kGap, page);
}

void caption(Field<Rgb8>& page) {
    const std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" font-family=\""
        "DejaVu Sans\" font-size=\"26\" fill=\"#fff\" text-anchor=\"middle\">"
        "<text x=\"{2}\" y=\"30\">A</text><text x=\"{3}\" y=\"30\">B</text></svg>",
        page.width(), page.height(), kGap + kWidth / 2, 2 * kGap + kWidth + kWidth / 2);
    const Field<Rgba8> drawn =
        drawn_svg("caption", text, page.width(), page.height(), SvgEdges::kSmooth);
    for (std::size_t i = 0; i < page.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            page[i][c] = std::max(page[i][c], static_cast<std::uint8_t>(drawn[i][3]));
}

}  // namespace

Field<Rgb8> blind_page(const Terrain& a, const Terrain& b, const View& view) {
    Field<Rgb8> page(3 * kGap + 2 * kWidth, kCaption + 2 * kHeight + 2 * kGap,
                     {34, 34, 34});
    caption(page);
    lay_land(a, view, kGap, page);
    lay_land(b, view, 2 * kGap + kWidth, page);
    return page;
}

}  // namespace cydonia::bench
