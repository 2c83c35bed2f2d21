#pragma once

#include <string>
#include <string_view>

#include "field/enum_names.h"

namespace cydonia::render {

// The files that belong to one shot, beside those that all shots of a land share. Each is
// the shot's name, a full stop and what the file holds. No full stop stands in a shot's
// name, but the one before a moment's number, and no file of the land ends like these: so
// no two shots, and no shot and its land, write the same file.
enum class ShotFile {
    kScene,            // for POV-Ray to draw
    kSettings,         // size and quality for POV-Ray
    kFrame,            // linear Rec.709
    kSky,              // latitude and longitude
    kCloudShadows,     // where clouds throw shadows
    kThings,           // the things on the ground
    kUnfinishedFrame,  // while POV-Ray works
    kUnfinishedState,  // POV-Ray's own, beside it
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

// "oblique.s001": one of the moments, from 1, over which a shot is averaged.
std::string moment_name(std::string_view shot, int number);

// 1 to 64 of A-Z a-z 0-9 _ -, and a moment's number where it is one.
bool is_shot_name(std::string_view name);

}  // namespace cydonia::render
