#include "config/reader/library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "config/reader/elevation_models.h"
#include "config/reader/mistakes.h"
#include "config/reader/parse.h"
#include "config/reader/table.h"
#include "config/reader/thesis.h"
#include "field/error.h"
#include "field/files.h"

namespace cydonia::config {

using genetic::Example;
using genetic::LibraryOptions;
using genetic::Seam;
using genetic::Transition;
using genetic::TypeOptions;

namespace {

constexpr std::size_t kMostBytes = 1u << 20;
constexpr std::size_t kMostTypes = 64, kMostExamples = 256, kMostLevels = 16;
constexpr std::size_t kLongestName = 64, kMostSeams = 1024;

}  // namespace

void read(Table& t, Example& example) {
    t.required("source", example.source, ElevationModel{});
    t.field("window", example.window, Number{from(0.0, 1.0)});
    t.field("scale", example.scale, Number{above_to(0.0, 1000.0)});
    t.field("vertical_scale", example.vertical_scale, Number{above_to(0.0, 1000.0)});
    t.field("raise", example.raise, Number{from(-1e5, 1e5)});
    t.check(
        example.window[0] < example.window[2] && example.window[1] < example.window[3],
        {"window"},
        "must be west, south, east and north as shares, such as [0.0, 0.5, 0.5, 1.0]");
}

void read(Table& t, TypeOptions& type, const std::vector<TypeOptions>& all) {
    t.required("name", type.name, Text{kLongestName});
    t.field("colour", type.colour, Colour{});
    const Colour::Rgb black{};
    t.check(!t.has("colour") || type.colour != black, {"colour"},
            "black is the colour of lines; choose another colour");
    for (const TypeOptions& other : all)
        if (&other < &type && other.colour == type.colour && type.colour != black)
            t.check(false, {"colour"},
                    fmt::format("'{}' has this colour already", other.name));
    std::vector<std::vector<Source>> found;
    t.field("examples", found, OneOrMore{ElevationModels{}});
    for (const auto& sources : found)
        for (const Source& source : sources) type.examples.push_back({source});
    std::vector<Example> parts;
    t.tables("example", parts, kMostExamples);
    type.examples.insert(type.examples.end(), parts.begin(), parts.end());
    t.check(type.examples.size() <= kMostExamples, {"examples", "example"},
            fmt::format("{} examples are too many; at most {}", type.examples.size(),
                        kMostExamples));
}

namespace {

// Reads the names of two different types, in any order.
void read_between(Table& t, std::string& a, std::string& b,
                  const std::vector<std::string>& names) {
    std::vector<std::string> between;
    t.required("between", between, Text{kLongestName});
    t.check(between.size() == 2 && between[0] != between[1], {"between"},
            "must name two different types, such as [\"plain\", \"mountains\"]");
    for (const std::string& name : between)
        t.check(std::ranges::find(names, name) != names.end(), {"between"},
                fmt::format("no type '{}'{}", name, suggestion(name, names)));
    if (between.size() == 2) a = between[0], b = between[1];
}

}  // namespace

void read(Table& t, Seam& seam, const std::vector<std::string>& names) {
    read_between(t, seam.a, seam.b, names);
    t.required("smoothness", seam.smoothness, Number{from(0.0, 1.0)});
}

void read(Table& t, Transition& transition, const std::vector<std::string>& names) {
    read_between(t, transition.a, transition.b, names);
    t.required("type", transition.type, Text{kLongestName});
    t.check(std::ranges::find(names, transition.type) != names.end(), {"type"},
            fmt::format("no type '{}'{}", transition.type,
                        suggestion(transition.type, names)));
    t.field("width", transition.width, Number{above_to(0.0, 1e7)});
}

void read(Table& t, LibraryOptions& library) {
    t.tables("type", library.types, kMostTypes, library.types);
    t.check(!library.types.empty(), {"type"}, "the library has no types; add [[type]]");
    t.unique("type", "name");
    colour_types(library);
    std::vector<std::string> names;
    for (const TypeOptions& type : library.types) names.push_back(type.name);
    t.tables("seam", library.seams, kMostSeams, names);
    t.tables("transition", library.transitions, kMostSeams, names);
    t.field("levels", library.levels, Number{from(0.01, 1e6)});
    t.check(!library.levels.empty() && library.levels.size() <= kMostLevels, {"levels"},
            fmt::format("needs 1 to {} levels", kMostLevels));
    t.check(std::ranges::is_sorted(library.levels, std::greater<>{}), {"levels"},
            "must be spacings in metres, from coarse to fine");
}

void colour_types(LibraryOptions& library) {
    using Rgb = std::array<std::uint8_t, 3>;
    // Colours that everybody can distinguish (Okabe and Ito 2008).
    constexpr std::array<Rgb, 8> kColours = {{{0x00, 0x72, 0xb2},
                                              {0xd5, 0x5e, 0x00},
                                              {0x00, 0x9e, 0x73},
                                              {0xcc, 0x79, 0xa7},
                                              {0xe6, 0x9f, 0x00},
                                              {0x56, 0xb4, 0xe9},
                                              {0xf0, 0xe4, 0x42},
                                              {0x44, 0x44, 0x44}}};
    // After those, hues a golden angle apart: 137 degrees.
    const auto colour = [&](std::size_t i) -> Rgb {
        if (i < kColours.size()) return kColours[i];
        Rgb rgb;
        for (std::size_t c = 0; c < 3; ++c)
            rgb[c] = std::uint8_t(std::lround(
                140.0 + 80.0 * std::cos(2.39996 * double(i) - 2.0944 * double(c))));
        return rgb;
    };
    std::set<Rgb> taken;
    for (const TypeOptions& type : library.types) taken.insert(type.colour);
    std::size_t next = 0;
    for (TypeOptions& type : library.types)
        if (type.colour == Rgb{}) {
            while (!taken.insert(colour(next)).second) ++next;
            type.colour = colour(next);
        }
}

LibraryOptions load_library(const std::filesystem::path& file) {
    if (file.extension() == ".ttl") return load_thesis_library(file);
    const Origins origins{file.string(), {}};
    const Value root = parse(read_text(file, kMostBytes), origins.file);
    Files files(file.parent_path());
    Reading reading{files};
    Table table(reading, &root, root.at);
    LibraryOptions library;
    library.name = file.stem().string();
    read(table, library);
    table.report_unknown();
    if (!reading.mistakes.empty())
        throw bad_request("{}", listed(std::move(reading.mistakes), origins));
    return library;
}

}  // namespace cydonia::config
