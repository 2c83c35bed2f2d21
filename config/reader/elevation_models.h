#pragma once

#include <string>
#include <vector>

#include "config/reader/units.h"

namespace cydonia::config {

inline constexpr std::size_t kMostModels = 255;  // that a name may stand for

// An elevation model: a file, or "package:NAME" for one that a Debian package brings.
struct ElevationModel {
    static constexpr bool kVaries = false;
    Source read(const Value& value, Files& files) const;
    std::string text(const Source& source) const { return File{}.text(source); }
    std::string schema() const { return File{}.schema(); }
};

// One or, as "dems/*.tif", several of them.
struct ElevationModels {
    static constexpr bool kVaries = false;
    std::vector<Source> read(const Value& value, Files& files) const;
    std::string text(const Source& source) const { return File{}.text(source); }
    std::string schema() const { return File{}.schema(); }
};

}  // namespace cydonia::config
