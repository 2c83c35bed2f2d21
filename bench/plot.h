#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace cydonia::bench {

struct Axis {
    std::string label;
    double from = 0.0, to = 1.0;
    bool logarithmic = false;
};

struct Plot {
    std::string title;
    Axis x, y;
    struct Points {
        std::string name, colour;
        std::vector<std::array<double, 2>> at;
        double radius = 3.5;  // pixels
    };
    std::vector<Points> points;
    struct Bars {
        std::string colour;
        double width = 1.0;                     // along x
        std::vector<std::array<double, 2>> at;  // where a bar begins, and its height
    };
    std::vector<Bars> bars;
};

// folder/name.svg with the plots beside each other, and the same as folder/name.png.
void write_plots(const std::filesystem::path& folder, const std::string& name,
                 const std::vector<Plot>& plots);

}  // namespace cydonia::bench
