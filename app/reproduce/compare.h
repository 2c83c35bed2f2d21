#pragma once

#include <filesystem>
#include <string>

#include "app/reproduce/manifest_file.h"

namespace cydonia {

// How close a file that was made again is to the first one, the closest first.
enum class Likeness {
    kEqual,        // in every byte
    kSamePixels,   // in every pixel; headers carry dates
    kAlike,        // as close as POV-Ray's radiosity is from run to run
    kNotCompared,  // has timings in it, or is a video, whose frames are compared
    kDifferent,
    kMissing,  // was not made again
};

struct Comparison {
    Likeness likeness;
    std::string detail;  // "rms 0.012, at most 0.31"; may be empty
};

// Frames of preview and final quality are alike up to this root mean square difference of
// pixel values, which are 0 to 1.
inline constexpr double kAlikeRms = 0.02;

// Compares the file that the manifest describes, `first`, with the one made now, `again`:
// heights by bytes, pictures by pixels. `jittered` frames were lit by POV-Ray's radiosity
// and need only be alike.
Comparison compare(const ManifestFile::Output& output, const std::filesystem::path& first,
                   const std::filesystem::path& again, bool jittered);

bool is_failure(Likeness likeness);
std::string text_of(const Comparison& comparison);

}  // namespace cydonia
