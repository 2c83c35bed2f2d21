#pragma once

#include <string>
#include <string_view>

#include "field/enum_names.h"

namespace cydonia::render {

// The files of one shot in the folder of a .pov. A file is named by the shot, a full stop
// and one of the endings below. The name of a camera has no full stop, the name of a
// moment only the one before its number, and no file that all shots share has one of the
// endings. Therefore no two shots, and no shot and its land, write the same file.
enum class ShotFile {
    kScene,            // for POV-Ray to draw
    kSettings,         // size and quality for POV-Ray
    kFrame,            // linear Rec.709
    kSky,              // a latitude-longitude image
    kCloudShadows,     // the map of the shadows of clouds
    kThings,           // the things on the ground
    kUnfinishedFrame,  // kFrame while POV-Ray renders
    kUnfinishedState,  // what POV-Ray keeps beside it
};
inline constexpr Name<ShotFile> kShotFiles[] = {
    {"pov", ShotFile::kScene},
    {"ini", ShotFile::kSettings},
    {"exr", ShotFile::kFrame},
    {"sky.exr", ShotFile::kSky},
    {"clouds.png", ShotFile::kCloudShadows},
    {"things.inc", ShotFile::kThings},
    {"part.exr", ShotFile::kUnfinishedFrame},
    {"part.pov-state", ShotFile::kUnfinishedState},
};
static_assert(is_complete(kShotFiles, ShotFile::kUnfinishedState));

std::string file_of(std::string_view shot, ShotFile file);

// The name of a moment over which a shot is averaged, counted from 1: "oblique.s001".
std::string moment_name(std::string_view shot, int number);

// Whether a name is 1 to 64 characters of A-Z a-z 0-9 _ -, or that of a moment.
bool is_shot_name(std::string_view name);

}  // namespace cydonia::render
