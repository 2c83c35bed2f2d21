#include "render/pov/scene.h"

#include <fmt/core.h>

#include <algorithm>

#include "field/error.h"
#include "render/pov/pieces.h"
#include "render/scene/files.h"

namespace cydonia::render {
namespace pov {

std::string comment(std::string_view text) {
    std::string line(text);
    std::ranges::replace_if(
        line, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    return line;
}

std::string number(double value) {
    return fmt::format("{:.9g}", value == 0.0 ? 0.0 : value);
}

std::string numbers(const Vec3& v) {
    return fmt::format("{}, {}, {}", number(v.x), number(v.y), number(v.z));
}

// Four digits are as fine as a film grade, and equal on every processor.
std::string numbers(const Rgb& colour) {
    return fmt::format("{:.4g}, {:.4g}, {:.4g}", colour[0], colour[1], colour[2]);
}

bool has_radiosity(Quality quality) { return quality != Quality::kDraft; }

namespace {

std::string header(const Shot& shot, bool has_water,
                   const std::vector<std::string>& added) {
    std::string beside = has_water ? "heights.png, water.png, " : "heights.png, ";
    for (const std::string& name : added) beside.append(name).append(", ");
    return fmt::format(R"(// {0}
//
// A landscape by Cydonia. In the folder of this file, with POV-Ray 3.7:
//
//     povray {1}
//
// It needs {2}ground.png, sky_visibility.png and {3} beside it, and
// draws {4}: linear light, Rec.709 primaries, no exposure.

#version 3.7;

)",
                       comment(shot.title), file_of(shot.name, ShotFile::kSettings),
                       beside, file_of(shot.name, ShotFile::kSky),
                       file_of(shot.name, ShotFile::kFrame));
}

// The name becomes part of file names and of quoted strings.
void check_name(const std::string& name) {
    if (!is_shot_name(name))
        throw bad_request("a camera's name is 1 to 64 of A-Z a-z 0-9 _ -, not '{}'",
                          comment(name));
}

}  // namespace
}  // namespace pov

std::string pov_scene(const Shot& shot, const Heights16& heights, double spacing,
                      const std::optional<WaterSurface>& water,
                      const std::vector<std::string>& added) {
    pov::check_name(shot.name);
    std::string text = pov::header(shot, water.has_value(), added);
    text += pov::land_numbers(heights, spacing);
    text += pov::light_numbers(shot, heights.levels.width() * spacing);
    text += pov::settings(shot);
    text += pov::camera(shot);
    text += pov::sun(shot);
    text += pov::sky(shot);
    if (has_haze(shot)) text += pov::haze();
    if (pov::has_stars(shot)) text += pov::stars(shot);
    text += pov::ground(shot);
    text += pov::outskirts(shot, heights, water && water->sea);
    if (shot.options.water) text += pov::flood(shot);
    if (water) text += pov::water(shot, *water);
    return text;
}

}  // namespace cydonia::render
