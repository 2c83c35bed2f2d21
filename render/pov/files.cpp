// Writes the folder of a .pov. It is flat because POV-Ray's file security demands it.
#include <fmt/core.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "field/files.h"
#include "field/parallel.h"
#include "field/rgb.h"
#include "render/pov/pieces.h"
#include "render/pov/scene.h"
#include "render/pov/things.h"
#include "render/scene/files.h"
#include "render/sky/clouds.h"
#include "render/sky/haze.h"
#include "render/sky/sky.h"

namespace cydonia::render {
namespace {

namespace fs = std::filesystem;

constexpr int kDomeHeight = 256;
constexpr int kShade = 2048;  // pixels a side
constexpr int kPacked = 1;    // compression level: each file is read once

// The sRGB level of linear light in 65536 steps, the finest a twentieth of a level.
const std::vector<std::uint8_t>& srgb_levels() {
    static const std::vector<std::uint8_t> levels = [] {
        std::vector<std::uint8_t> result(65536);
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] = srgb_level(static_cast<double>(i) / 65535.0);
        return result;
    }();
    return levels;
}

Field<Rgb8> srgb(const Field<Rgb>& linear) {
    Field<Rgb8> result(linear.width(), linear.height());
    const std::vector<std::uint8_t>& levels = srgb_levels();
    parallel_for(linear.height(), 8, [&](int y) {
        for (int x = 0; x < linear.width(); ++x)
            for (std::size_t c = 0; c < 3; ++c)
                result(x, y)[c] = levels[static_cast<std::size_t>(
                    65535.0f * std::clamp(linear(x, y)[c], 0.0f, 1.0f) + 0.5f)];
    });
    return result;
}

Field<std::uint16_t> levels_of(const Field<float>& share) {
    Field<std::uint16_t> result(share.width(), share.height());
    std::ranges::transform(share, result.begin(), [](float v) {
        return static_cast<std::uint16_t>(
            std::lround(65535.0f * std::clamp(v, 0.0f, 1.0f)));
    });
    return result;
}

const char* antialiasing(Quality quality) {
    switch (quality) {
        case Quality::kDraft:
            return "Antialias=Off\n";
        case Quality::kPreview:
            return "Antialias=On\nAntialias_Threshold=0.3\nSampling_Method=1\n"
                   "Antialias_Depth=2\n";
        case Quality::kFinal:
            break;
    }
    return "Antialias=On\nAntialias_Threshold=0.15\nSampling_Method=2\n"
           "Antialias_Depth=2\n";
}

std::string ini(const Shot& shot) {
    return fmt::format(R"(; povray {0}
Input_File_Name={1}
Output_File_Name={2}
Output_File_Type=E
Width={3}
Height={4}
{5}Display=Off
Pause_When_Done=Off
)",
                       file_of(shot.name, ShotFile::kSettings),
                       file_of(shot.name, ShotFile::kScene),
                       file_of(shot.name, ShotFile::kFrame), shot.camera.width,
                       shot.camera.height, antialiasing(shot.quality));
}

// The sky's image. POV-Ray's fog lies over the sky too, so the fog is taken out of it.
Field<Rgb> dome_of(const Shot& shot, const Terrain& terrain) {
    Field<Rgb> dome = sky_dome(shot.sun, shot.options.sky, kDomeHeight);
    if (!has_haze(shot)) return dome;
    const double eye = shot.camera.eye.z - std::ranges::min(terrain.heights);
    return behind_haze(dome, haze_light(shot),
                       visibility(shot.options.sky, shot.options.haze, terrain.width()),
                       eye);
}

// The sheet that casts the shadows of clouds: above all land, as wide as its
// surroundings, and moved toward the sun so that its shadow falls on the land.
std::optional<pov::CloudShade> cloud_shade(const Shot& shot, const Terrain& terrain) {
    if (!throw_shadows(shot.options.sky, shot.sun, !terrain.shadows.empty()))
        return std::nullopt;
    const auto [low, high] = std::ranges::minmax(terrain.heights);
    const double up = static_cast<double>(high) - low + 200.0;
    const Vec3 to_sun = direction_to(shot.sun);
    const double reach = up / to_sun.z;
    return pov::CloudShade{
        shot.name,
        {reach * to_sun.x, reach * to_sun.y, up},
        5.0 * std::max(terrain.width(), terrain.depth()) + 2.0 * reach};
}

}  // namespace

std::vector<std::string> write_pov_assets(const fs::path& folder, const Terrain& terrain,
                                          const LandMaps& maps) {
    // One thread for each file, since compression is most of the work.
    tbb::parallel_invoke(
        [&] {
            write_png(folder / "heights.png", quantised(terrain.heights).levels, kPacked);
        },
        [&] { write_png(folder / "ground.png", srgb(maps.ground.albedo), kPacked); },
        [&] { write_png(folder / "materials.png", maps.ground.materials, kPacked); },
        [&] {
            write_png(folder / "sky_visibility.png", levels_of(maps.sky_visibility),
                      kPacked);
        });
    std::vector<std::string> names{"heights.png", "ground.png", "materials.png",
                                   "sky_visibility.png"};
    if (const auto water = water_surface(terrain)) {
        write_png(folder / "water.png", water->heights.levels);
        names.push_back("water.png");
    }
    return names;
}

std::vector<std::string> write_pov_scene(const fs::path& folder, const Shot& shot,
                                         const Terrain& terrain) {
    const auto shade = cloud_shade(shot, terrain);
    const std::string things = pov::things(shot, terrain);
    std::vector<std::string> added;
    if (shade) {
        added.push_back(file_of(shot.name, ShotFile::kCloudShadows));
        write_png(folder / added.back(),
                  levels_of(cloud_shadows(shot.sun, shade->middle, shade->size, kShade)),
                  kPacked);
    }
    if (!things.empty()) {
        added.push_back(file_of(shot.name, ShotFile::kThings));
        write_text(folder / added.back(), things);
    }
    std::string scene = pov_scene(shot, quantised(terrain.heights), terrain.spacing,
                                  water_surface(terrain), added);
    if (shade) scene += pov::cloud_shade(*shade);
    if (!things.empty()) scene += fmt::format("#include \"{}\"\n", added.back());

    std::vector<std::string> names{file_of(shot.name, ShotFile::kSky),
                                   file_of(shot.name, ShotFile::kScene),
                                   file_of(shot.name, ShotFile::kSettings)};
    write_exr(folder / names[0], dome_of(shot, terrain));
    write_text(folder / names[1], scene);
    write_text(folder / names[2], ini(shot));
    names.insert(names.end(), added.begin(), added.end());
    return names;
}

}  // namespace cydonia::render
