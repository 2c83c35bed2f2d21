#pragma once

#include <string>
#include <vector>

namespace cydonia {

// One scene of the gallery.
struct Exhibit {
    struct Picture {
        std::string file;  // relative to the page
        std::string label;
    };
    std::string name;     // of the scene's folder
    std::string title;    //
    std::string about;    // the comment that the scene file begins with
    std::string command;  // that makes the frames
    std::vector<Picture> pictures;
    double synthesis = 0.0, render = 0.0;  // seconds of the last run
    std::string failure;                   // why it could not be made; empty if it was
};

}  // namespace cydonia
