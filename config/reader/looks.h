#pragma once

#include <functional>
#include <string>
#include <vector>

#include "config/reader/table.h"
#include "render/options.h"

namespace cydonia::config {

// What a look file gives: what lies where, and how the light of a scene in it begins.
struct LookFile {
    render::Look look;
    render::SkyOptions sky;
    render::HazeOptions haze;
    render::FineReliefOptions fine_relief;
    double exposure = 0.0;
    std::vector<Source> materials;  // every material's file, in the look's order
};

// A look that ships with the program (config/looks), or a file of the user's own,
// "mine.toml".
struct LookName {
    static constexpr bool kVaries = false;
    Source read(const Value& value, Files& files) const;
    std::string text(const Source& source) const { return File{}.text(source); }
    std::string schema() const { return File{}.schema(); }
};

void read(Table& t, render::Layer& layer, std::vector<Source>& materials);

// Of a scene that names none.
Source default_look();

// Reads a look and its materials. Throws bad_request with every mistake of the file as
// file:line:column: message.
LookFile read_look(const Source& source);
// looks_materials.cpp
render::Material read_material(const Source& source);

// Reads a small file that is all one table. Throws bad_request as read_look does.
void read_data_file(const Source& source, const std::function<void(Table&)>& read);

// A shipped file of the folder ("looks") by its name, or any other one as "mine.toml".
Source named_file(const Value& value, Files& files, std::string_view folder,
                  std::string_view what);

}  // namespace cydonia::config
