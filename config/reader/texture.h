#pragma once

#include <string>
#include <vector>

#include "config/reader/elevation_models.h"
#include "config/reader/table.h"
#include "synth/texture/options.h"

namespace cydonia::config {

// The names that the parts of a texture stage may refer to, as far as the stage was read.
struct TextureNames {
    std::vector<std::string> types;
    std::vector<std::string> exemplars;    // without their files' extension
    std::vector<std::string> constraints;  // points and curves
    std::vector<std::string> pastes;
};

// texture::Match has a byte for them.
inline constexpr std::size_t kMostExemplars = kMostModels;

void read(Table& t, geometry::Point& point, TextureNames& names);  // texture_shapes.cpp
void read(Table& t, geometry::Curve& curve, TextureNames& names);  // texture_shapes.cpp
void read(Table& t, texture::Paste& paste, TextureNames& names);   // texture_pastes.cpp

// `name`, "point 3" unless the file gives one; no two the same.
void read_name(Table& t, std::string& name, std::string_view kind, std::size_t number,
               std::vector<std::string>& taken);  // texture.cpp

}  // namespace cydonia::config
