#include "config/reader/library.h"

#include <fmt/format.h>

#include <algorithm>

#include "config/reader/elevation_models.h"
#include "config/reader/library_ttl.h"
#include "config/reader/mistakes.h"
#include "config/reader/parse.h"
#include "config/reader/table.h"
#include "field/error.h"
#include "field/files.h"

namespace cydonia::config {

using genetic::Example;
using genetic::LibraryOptions;
using genetic::TypeOptions;

namespace {

constexpr std::size_t kMostBytes = 1u << 20;
constexpr std::size_t kMostTypes = 64, kMostExamples = 256, kMostLevels = 16;
constexpr std::size_t kLongestName = 64;

}  // namespace

void read(Table& t, Example& example) {
    t.required("source", example.source, ElevationModel{});
    t.field("window", example.window, Number{from(0.0, 1.0)});
    t.check(
        example.window[0] < example.window[2] && example.window[1] < example.window[3],
        {"window"}, "is west, south, east and north, each a share: [0.0, 0.5, 0.5, 1.0]");
}

void read(Table& t, TypeOptions& type) {
    t.required("name", type.name, Text{kLongestName});
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

void read(Table& t, LibraryOptions& library) {
    t.tables("type", library.types, kMostTypes);
    t.check(!library.types.empty(), {"type"}, "the library has no types; add [[type]]");
    t.unique("type", "name");
    t.field("levels", library.levels, Number{from(0.01, 1e6)});
    t.check(!library.levels.empty() && library.levels.size() <= kMostLevels, {"levels"},
            fmt::format("needs 1 to {} levels", kMostLevels));
    t.check(std::ranges::is_sorted(library.levels, std::greater<>{}), {"levels"},
            "are metres from sample to sample, coarse to fine");
}

LibraryOptions load_library(const std::filesystem::path& file) {
    if (file.extension() == ".ttl") return load_ttl(file);
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
