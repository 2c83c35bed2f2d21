#include "config/reader/thesis.h"

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

// The line up to its comment; a # within quotes begins none.
std::string_view uncommented(std::string_view line) {
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') quoted = !quoted;
        if (line[i] == '#' && !quoted) return line.substr(0, i);
    }
    return line;
}

// The model in the folder that has this name, with or without an ending. Names that lead
// out of the folder find nothing.
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

bool is_between(double value, double low, double high) {
    return value >= low && value <= high;  // false for a NaN
}

// Reads a library line by line: a section opens a type or a seam, the lines after it set
// its values.
class ThesisLibrary {
  public:
    explicit ThesisLibrary(const fs::path& file) : file_(file) {
        library_.name = file.stem().string();
    }

    genetic::LibraryOptions read() {
        std::istringstream lines(read_text(file_, kMostBytes));
        for (std::string line; std::getline(lines, line);) {
            ++line_;
            const std::string text = trimmed(uncommented(line));
            if (text.empty()) continue;
            if (text.front() == '[')
                open_section(text);
            else
                set_value(text);
        }
        if (library_.types.empty())
            throw bad_request("{}: it has no section [Terrain Type: NAME]",
                              file_.string());
        check_seams();
        colour_types(library_);
        return std::move(library_);
    }

  private:
    Error wrong_at(int line, const std::string& why) const {
        return bad_request("{}:{}: {}", file_.string(), line, why);
    }
    Error wrong(const std::string& why) const { return wrong_at(line_, why); }

    // Sections of other kinds are passed over with their values.
    void open_section(const std::string& text) {
        if (text.back() != ']') throw wrong("a section ends with ]");
        const std::string section = trimmed(text.substr(1, text.size() - 2));
        type_ = nullptr;
        seam_ = nullptr;
        if (section.starts_with(kSeam)) open_seam(section.substr(kSeam.size()));
        if (section.starts_with(kType)) open_type(trimmed(section.substr(kType.size())));
    }

    void open_seam(const std::string& pair) {
        const std::size_t ampersand = pair.find('&');
        if (ampersand == pair.npos)
            throw wrong("a terrain seam is [Terrain Seam: A & B]");
        if (library_.seams.size() == kMostSeams)
            throw wrong(fmt::format("more than {} seams", kMostSeams));
        seam_ = &library_.seams.emplace_back();
        seam_->a = trimmed(pair.substr(0, ampersand));
        seam_->b = trimmed(pair.substr(ampersand + 1));
        seam_lines_.push_back(line_);
    }

    void open_type(const std::string& name) {
        if (name.empty() || name.size() > 64)
            throw wrong("a terrain type needs a name of at most 64 bytes");
        if (std::ranges::find(library_.types, name, &genetic::TypeOptions::name) !=
            library_.types.end())
            throw wrong(fmt::format("there are two terrain types '{}'", name));
        if (library_.types.size() == kMostTypes)
            throw wrong(fmt::format("more than {} terrain types", kMostTypes));
        type_ = &library_.types.emplace_back();
        type_->name = name;
    }

    void set_value(const std::string& text) {
        const std::size_t equals = text.find('=');
        if (equals == text.npos) throw wrong("expected 'key = value'");
        const std::string key = trimmed(text.substr(0, equals));
        const std::string value = trimmed(text.substr(equals + 1));
        if (seam_ && key == "smoothness") set_smoothness(value);
        if (type_ && key == "color") set_colour(value);
        if (type_ && key == "sample") add_sample(value);
    }

    void set_smoothness(const std::string& value) {
        char* end = nullptr;
        seam_->smoothness = std::strtod(value.c_str(), &end);
        if (end == value.c_str() || *end != '\0' ||
            !is_between(seam_->smoothness, 0.0, 1.0))
            throw wrong(fmt::format("smoothness goes from 0 to 1, and is '{}'",
                                    value.substr(0, 40)));
    }

    void set_colour(const std::string& value) {
        std::array<double, 3> rgb{};
        const int read =
            std::sscanf(value.c_str(), "<%lf ,%lf ,%lf", &rgb[0], &rgb[1], &rgb[2]);
        const auto is_share = [](double v) { return is_between(v, 0.0, 1.0); };
        if (read != 3 || !std::ranges::all_of(rgb, is_share))
            throw wrong(
                fmt::format("a color is <red, green, blue, alpha>, each from 0 to 1, and "
                            "is '{}'",
                            value.substr(0, 40)));
        for (std::size_t i = 0; i < rgb.size(); ++i)
            type_->colour[i] = std::uint8_t(std::lround(255.0 * rgb[i]));
    }

    void add_sample(const std::string& value) {
        if (value.size() < 2 || value.front() != '"' || value.back() != '"')
            throw wrong("a sample is a name in quotes");
        const std::string name = value.substr(1, value.size() - 2);
        const auto model = model_called(file_.parent_path(), name);
        if (!model)
            throw wrong(fmt::format(
                "no elevation model '{}' beside the library (with .tif, .dem, .hgt, ...)",
                name));
        if (type_->examples.size() == kMostExamples)
            throw wrong(fmt::format("more than {} samples", kMostExamples));
        type_->examples.push_back({open_source(*model)});
    }

    // At the end, as seams may stand before their types.
    void check_seams() const {
        std::vector<std::string> names;
        for (const auto& type : library_.types) names.push_back(type.name);
        for (std::size_t i = 0; i < seam_lines_.size(); ++i) {
            const genetic::Seam& seam = library_.seams[i];
            for (const std::string& name : {seam.a, seam.b})
                if (std::ranges::find(names, name) == names.end())
                    throw wrong_at(seam_lines_[i],
                                   fmt::format("no terrain type '{}'{}", name,
                                               suggestion(name, names)));
            if (seam.a == seam.b)
                throw wrong_at(
                    seam_lines_[i],
                    fmt::format("a seam is between two types, and '{}' is one", seam.a));
        }
    }

    const fs::path& file_;
    genetic::LibraryOptions library_;
    genetic::TypeOptions* type_ = nullptr;  // of the open section, in library_
    genetic::Seam* seam_ = nullptr;
    std::vector<int> seam_lines_;  // where each seam's section stands
    int line_ = 0;
};

}  // namespace

genetic::LibraryOptions load_thesis_library(const fs::path& file) {
    return ThesisLibrary(file).read();
}

}  // namespace cydonia::config
