#pragma once

#include <filesystem>
#include <string>

#include "app/reproduce/manifest_file.h"

namespace cydonia {

// How a file that was made again is like the first one, the best first.
enum class Likeness {
    kEqual,        // every byte
    kSamePixels,   // every pixel, but not every byte: headers carry dates
    kAlike,        // within what POV-Ray's radiosity differs by from run to run
    kNotCompared,  // holds timings or is a video, which its frames decide
    kDifferent,
    kMissing,  // was not made again
};

struct Comparison {
    Likeness likeness;
    std::string detail;  // "rms 0.012, at most 0.31"; may be empty
};

// Root mean square of the differences of pixel values, 0 to 1, up to which frames of
// preview and final quality are alike.
inline constexpr double kAlikeRms = 0.02;

// `first` is where the manifest found the file and `again` where it was made now. Heights
// are compared by bytes and pictures by pixels; `jittered`: a frame that POV-Ray's
// radiosity drew.
Comparison compare(const ManifestFile::Output& output, const std::filesystem::path& first,
                   const std::filesystem::path& again, bool jittered);

bool is_failure(Likeness likeness);
std::string text_of(const Comparison& comparison);

}  // namespace cydonia
