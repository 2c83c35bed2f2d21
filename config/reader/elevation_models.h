#pragma once

#include <string>
#include <vector>

#include "config/reader/units.h"

namespace cydonia::config {

inline constexpr std::size_t kMostModels = 255;  // that a name may stand for

// The unit of an elevation model: a file, or "package:NAME" for one that a Debian package
// contains.
struct ElevationModel {
    static constexpr bool kVaries = false;
    Source read(const Value& value, Files& files) const;
    std::string text(const Source& source) const { return File{}.text(source); }
    std::string schema() const { return File{}.schema(); }
};

// The unit of one elevation model or, as "dems/*.tif", of several.
struct ElevationModels {
    static constexpr bool kVaries = false;
    std::vector<Source> read(const Value& value, Files& files) const;
    std::string text(const Source& source) const { return File{}.text(source); }
    std::string schema() const { return File{}.schema(); }
};

}  // namespace cydonia::config
