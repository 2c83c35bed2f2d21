#pragma once

#include <string>
#include <vector>

namespace cydonia {

// One scene of the gallery.
struct Exhibit {
    struct Picture {
        std::string file;  // beside the page
        std::string label;
    };
    std::string name;     // of its folder
    std::string title;    //
    std::string about;    // what to look at: the scene file's first comment
    std::string command;  // that makes it
    std::vector<Picture> pictures;
    double synthesis = 0.0, render = 0.0;  // seconds, when it was last made
    std::string failure;                   // why it could not be made; empty: it was
};

}  // namespace cydonia
