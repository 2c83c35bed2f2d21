// Prints a drawing (SVG) of profiles to one scale, at a sea level cost of 60 thesis
// units: each file as it is, or with --cut the first one with layers and detail. For both
// pictures of docs/profiles.md, see bench/profiles.sh.
#include <fmt/core.h>

#include <string>
#include <string_view>
#include <vector>

#include "field/error.h"
#include "synth/distance/profile.h"

using namespace cydonia;
using distance::Profile;

namespace {

constexpr double kUnit = 10.0;  // metres
constexpr int kColumns = 4;
constexpr double kPixels = 1.6;  // a unit
constexpr double kBoxX = 290.0, kBoxY = 142.0, kFoot = 60.0 * kPixels;

struct Cell {
    std::string label;
    Profile profile;
};

Profile shipped(const char* file) {
    Profile profile;
    profile.curve.table = open_source(file);
    profile.name = profile.curve.table->path.stem();
    return profile;
}

std::vector<Cell> as_they_are(int count, char** files) {
    std::vector<Cell> cells;
    for (int i = 0; i < count; ++i) {
        const Profile profile = shipped(files[i]);
        cells.push_back({profile.name, profile});
    }
    return cells;
}

std::vector<Cell> cut(const char* file) {
    const Profile plain = shipped(file);
    std::vector<Cell> cells;
    for (const double hardness : {0.0, 0.4, 0.7, 1.0}) {
        cells.push_back({fmt::format("8 layers, hardness {}", hardness), plain});
        cells.back().profile.strata = {.layers = 8, .hardness = hardness};
    }
    for (const double detail : {0.3, 0.6, 1.0}) {
        cells.push_back({fmt::format("detail {}", detail), plain});
        cells.back().profile.detail = detail;
    }
    cells.push_back({"hardness 0.7, detail 0.6", plain});
    cells.back().profile.strata = {.layers = 8, .hardness = 0.7};
    cells.back().profile.detail = 0.6;
    return cells;
}

void print(const Cell& cell, std::size_t i) {
    const distance::Descent descent =
        distance::descent_of(cell.profile, 60.0 * kUnit, 1.0, 0.001, 512.0 * kUnit);
    std::string line;
    for (const auto& [distance, cost, slope, run] : descent.knots) {
        if (distance > descent.reach) break;  // the last, at infinity
        line += fmt::format(" {:.1f},{:.1f}", distance / kUnit * kPixels,
                            cost / kUnit * kPixels);
    }
    fmt::print(
        "<g transform='translate({} {})'><path d='M0 {} H258' stroke='#6d8fa6'/>\n",
        static_cast<double>(i % kColumns) * kBoxX + 16.0,
        static_cast<double>(i / kColumns) * kBoxY + 14.0, kFoot);
    fmt::print("<polygon points='0,{}{}' fill='#c9b797'/>\n", kFoot, line);
    fmt::print("<polyline points='{}' fill='none' stroke='#4a3b28' stroke-width='2'/>\n",
               line);
    fmt::print("<text y='{}'>{} <tspan fill='#857a68'>{:.0f}</tspan></text></g>\n",
               kFoot + 19.0, cell.label, descent.reach / kUnit);
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 2) {
        fmt::print(stderr, "profile_sheet [--cut] FILE.csv...\n");
        return 2;
    }
    const bool carved = std::string_view(argv[1]) == "--cut" && argc > 2;
    const auto cells = carved ? cut(argv[2]) : as_they_are(argc - 1, argv + 1);
    const std::size_t rows = (cells.size() + kColumns - 1) / kColumns;
    fmt::print(
        "<svg xmlns='http://www.w3.org/2000/svg' width='{}' height='{}' "
        "font-family='sans-serif' font-size='15'>\n"
        "<rect width='100%' height='100%' fill='#f6f4ee'/>\n",
        kColumns * kBoxX, static_cast<double>(rows) * kBoxY);
    for (std::size_t i = 0; i < cells.size(); ++i) print(cells[i], i);
    fmt::print("</svg>\n");
} catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(error.code());
}
