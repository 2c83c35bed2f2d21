#include "config/reader/library_ttl.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>

#include "config/reader/library.h"
#include "config/reader/mistakes.h"
#include "field/error.h"
#include "field/files.h"

namespace cydonia::config {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = 1u << 20, kMostTypes = 64, kMostExamples = 256;
constexpr std::size_t kMostSeams = 1024;
constexpr std::string_view kType = "Terrain Type:", kSeam = "Terrain Seam:";

std::string trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == text.npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

// Without a comment, unless the sign stands in quotes.
std::string_view uncommented(std::string_view line) {
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') quoted = !quoted;
        if (line[i] == '#' && !quoted) return line.substr(0, i);
    }
    return line;
}

// Of the folder, by its name with or without an ending; names lead nowhere else.
std::optional<fs::path> model_called(const fs::path& folder, const std::string& name) {
    if (name.empty() || name.find('/') != name.npos || name == "." || name == "..")
        return {};
    std::error_code none;
    if (fs::is_regular_file(folder / name, none)) return folder / name;
    for (const char* ending : {".tif", ".tiff", ".dem", ".hgt", ".asc", ".img", ".exr"})
        if (fs::is_regular_file(folder / (name + ending), none))
            return folder / (name + ending);
    return {};
}

// Seams may stand before their types.
void refuse_unknown(const genetic::LibraryOptions& library, const std::vector<int>& lines,
                    const fs::path& file) {
    std::vector<std::string> names;
    for (const auto& type : library.types) names.push_back(type.name);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const genetic::Seam& seam = library.seams[i];
        for (const std::string& name : {seam.a, seam.b})
            if (std::ranges::find(names, name) == names.end())
                throw bad_request("{}:{}: no terrain type '{}'{}", file.string(),
                                  lines[i], name, suggestion(name, names));
        if (seam.a == seam.b)
            throw bad_request("{}:{}: a seam is between two types, and '{}' is one",
                              file.string(), lines[i], seam.a);
    }
}

}  // namespace

genetic::LibraryOptions load_ttl(const fs::path& file) {
    genetic::LibraryOptions library;
    library.name = file.stem().string();
    std::istringstream lines(read_text(file, kMostBytes));
    genetic::TypeOptions* type = nullptr;
    genetic::Seam* seam = nullptr;
    std::vector<int> seam_lines;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const auto wrong = [&](const std::string& why) {
            return bad_request("{}:{}: {}", file.string(), number, why);
        };
        const std::string text = trimmed(uncommented(line));
        if (text.empty()) continue;
        if (text.front() == '[') {
            if (text.back() != ']') throw wrong("a section ends with ]");
            const std::string section = trimmed(text.substr(1, text.size() - 2));
            type = nullptr, seam = nullptr;
            if (section.starts_with(kSeam)) {
                const std::string pair = section.substr(kSeam.size());
                const std::size_t both = pair.find('&');
                if (both == pair.npos)
                    throw wrong("a terrain seam is [Terrain Seam: A & B]");
                if (library.seams.size() == kMostSeams)
                    throw wrong(fmt::format("more than {} seams", kMostSeams));
                seam = &library.seams.emplace_back();
                seam_lines.push_back(number);
                seam->a = trimmed(pair.substr(0, both));
                seam->b = trimmed(pair.substr(both + 1));
                continue;
            }
            if (!section.starts_with(kType)) continue;
            const std::string name = trimmed(section.substr(kType.size()));
            if (name.empty() || name.size() > 64)
                throw wrong("a terrain type needs a name of at most 64 bytes");
            if (std::ranges::any_of(
                    library.types, [&](const auto& other) { return other.name == name; }))
                throw wrong(fmt::format("there are two terrain types '{}'", name));
            if (library.types.size() == kMostTypes)
                throw wrong(fmt::format("more than {} terrain types", kMostTypes));
            type = &library.types.emplace_back();
            type->name = name;
            continue;
        }
        const std::size_t equals = text.find('=');
        if (equals == text.npos) throw wrong("expected 'key = value'");
        const std::string name_of_value = trimmed(text.substr(0, equals)),
                          value = trimmed(text.substr(equals + 1));
        if (seam && name_of_value == "smoothness") {
            char* end = nullptr;
            seam->smoothness = std::strtod(value.c_str(), &end);
            if (end == value.c_str() || *end != '\0' ||
                !(seam->smoothness >= 0.0 && seam->smoothness <= 1.0))
                throw wrong("smoothness goes from 0 to 1");
        }
        if (type && name_of_value == "color") {
            std::array<double, 3> rgb{-1.0, -1.0, -1.0};
            if (std::sscanf(value.c_str(), "<%lf ,%lf ,%lf", &rgb[0], &rgb[1], &rgb[2]) !=
                    3 ||
                !(std::ranges::min(rgb) >= 0.0 && std::ranges::max(rgb) <= 1.0))
                throw wrong("a color is <red, green, blue, alpha>, each 0 to 1");
            for (std::size_t i = 0; i < 3; ++i)
                type->colour[i] = std::uint8_t(std::lround(255.0 * rgb[i]));
        }
        if (!type || name_of_value != "sample") continue;
        if (value.size() < 2 || value.front() != '"' || value.back() != '"')
            throw wrong("a sample is a name in quotes");
        const std::string name = value.substr(1, value.size() - 2);
        const auto model = model_called(file.parent_path(), name);
        if (!model)
            throw wrong(fmt::format(
                "no elevation model '{}' beside the library (with .tif, .dem, .hgt, ...)",
                name));
        if (type->examples.size() == kMostExamples)
            throw wrong(fmt::format("more than {} samples", kMostExamples));
        type->examples.push_back({open_source(*model)});
    }
    if (library.types.empty())
        throw bad_request("{}: no [Terrain Type: NAME] in it", file.string());
    refuse_unknown(library, seam_lines, file);
    colour_types(library);
    return library;
}

}  // namespace cydonia::config
