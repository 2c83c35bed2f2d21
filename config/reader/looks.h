#pragma once

#include <functional>
#include <string>
#include <vector>

#include "config/reader/table.h"
#include "render/options.h"

namespace cydonia::config {

// The contents of a look file: which materials lie where, and the defaults of a scene's
// light.
struct LookFile {
    render::Look look;
    render::SkyOptions sky;
    render::HazeOptions haze;
    render::FineReliefOptions fine_relief;
    double exposure = 0.0;
    std::vector<Source> materials;  // every material's file, in the look's order
};

// The unit of a look: the name of one that ships with the program (config/looks), or a
// file of the user, such as "mine.toml".
struct LookName {
    static constexpr bool kVaries = false;
    Source read(const Value& value, Files& files) const;
    std::string text(const Source& source) const { return File{}.text(source); }
    std::string schema() const { return File{}.schema(); }
};

void read(Table& t, render::Layer& layer, std::vector<Source>& materials);

// The look of a scene that names none.
Source default_look();

// Reads a look and its materials. Throws bad_request with every mistake of the file as
// file:line:column: message.
LookFile read_look(const Source& source);
// looks_materials.cpp
render::Material read_material(const Source& source);

// Reads a small file that consists of one table. Throws bad_request as read_look does.
void read_data_file(const Source& source, const std::function<void(Table&)>& read);

// Finds a file that ships in `folder` ("looks") by its name, or any other file by its
// path, such as "mine.toml".
Source named_file(const Value& value, Files& files, std::string_view folder,
                  std::string_view what);

}  // namespace cydonia::config
