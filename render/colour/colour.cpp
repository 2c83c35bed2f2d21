#include "render/colour/colour.h"

#include <OpenColorIO/OpenColorIO.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <vector>

#include "field/data.h"
#include "field/error.h"
#include "field/parallel.h"

namespace OCIO = OCIO_NAMESPACE;

namespace cydonia::render {
namespace {

using Matrix = std::array<std::array<float, 3>, 3>;

// Rec.709 to XYZ, Bradford from D65 to the ACES white, XYZ to AP1 (S-2014-004).
constexpr Matrix kAcesCgFromRec709{{{0.6130974f, 0.3395231f, 0.0473795f},
                                    {0.0701937f, 0.9163539f, 0.0134524f},
                                    {0.0206156f, 0.1095698f, 0.8698146f}}};
constexpr Matrix kRec709FromAcesCg{{{1.7050510f, -0.6217921f, -0.0832589f},
                                    {-0.1302564f, 1.1408047f, -0.0105483f},
                                    {-0.0240034f, -0.1289690f, 1.1529725f}}};

float dot(const std::array<float, 3>& a, const Rgb& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::filesystem::path config_file(const ColourOptions& options) {
    if (options.config) return options.config->path;
    if (const char* named = std::getenv("OCIO"); named && *named) return named;
    return data_file("ocio/config.ocio");
}

// OpenColorIO's messages have several lines, ours one.
std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text.substr(0, text.find_last_not_of(' ') + 1);
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::exception& error) {
    const char* named = std::getenv("OCIO");
    throw bad_request("{}: not a usable OCIO config{}: {}", file.string(),
                      named && file == named ? " (named by $OCIO)" : "",
                      one_line(error.what()));
}

OCIO::ConstConfigRcPtr read_config(const std::filesystem::path& file) {
    try {
        OCIO::ConstConfigRcPtr config = OCIO::Config::CreateFromFile(file.c_str());
        config->validate();
        return config;
    } catch (const std::exception& error) {
        refuse(file, error);
    }
}

std::vector<std::string> displays_of(const OCIO::Config& config) {
    std::vector<std::string> names;
    for (int i = 0; i < config.getNumDisplays(); ++i)
        names.push_back(config.getDisplay(i));
    return names;
}

std::vector<std::string> views_of(const OCIO::Config& config,
                                  const std::string& display) {
    std::vector<std::string> names;
    for (int i = 0; i < config.getNumViews(display.c_str()); ++i)
        names.push_back(config.getView(display.c_str(), i));
    return names;
}

// The wish, or the default when nothing is wished for.
std::string chosen(const std::string& what, const std::string& wish,
                   const std::string& otherwise, const std::vector<std::string>& names) {
    const std::string& choice = wish.empty() ? otherwise : wish;
    if (std::find(names.begin(), names.end(), choice) != names.end()) return choice;
    throw bad_request("{} '{}' is unknown; there is: {}", what, choice,
                      fmt::format("{}", fmt::join(names, ", ")));
}

// The colour space our values enter by. Configs have called those we know by many names.
struct Entrance {
    const char* space;
    enum class Primaries { kAcesCg, kRec709, kAces2065 } primaries;
};

Entrance entrance_of(const OCIO::Config& config, const std::filesystem::path& file) {
    using enum Entrance::Primaries;
    for (const char* name : {"ACEScg", "ACES - ACEScg", "lin_ap1"})
        if (config.getColorSpace(name)) return {name, kAcesCg};
    // A role since OpenColorIO 2, there for this.
    for (const char* name : {"aces_interchange", "ACES2065-1", "ACES - ACES2065-1"})
        if (config.getColorSpace(name)) return {name, kAces2065};
    // Blender's and Nuke's own configs say no more than "linear", and mean Rec.709.
    for (const char* name :
         {"lin_rec709_srgb", "lin_rec709", "lin_srgb", "Linear Rec.709 (sRGB)",
          "Linear Rec.709", "Utility - Linear - Rec.709", "Utility - Linear - sRGB",
          "linear"})
        if (config.getColorSpace(name)) return {name, kRec709};
    throw bad_request(
        "{}: has no colour space named ACEScg or lin_rec709; give its linear colour "
        "space that alias",
        file.string());
}

OCIO::ConstTransformRcPtr rec709_from_acescg() {
    double m[16] = {};
    for (int row = 0; row < 3; ++row)
        std::copy_n(kAcesCgFromRec709[row].begin(), 3, m + 4 * row);
    m[15] = 1.0;
    const auto matrix = OCIO::MatrixTransform::Create();
    matrix->setMatrix(m);
    matrix->setDirection(OCIO::TRANSFORM_DIR_INVERSE);
    return matrix;
}

OCIO::TransformRcPtr aces2065_from_acescg() {
    const auto builtin = OCIO::BuiltinTransform::Create();
    builtin->setStyle("ACEScg_to_ACES2065-1");
    return builtin;
}

OCIO::ConstCPUProcessorRcPtr processor_of(const OCIO::Config& config,
                                          const Entrance& entrance,
                                          const std::string& display,
                                          const std::string& view) {
    const auto group = OCIO::GroupTransform::Create();
    if (entrance.primaries == Entrance::Primaries::kRec709)
        group->appendTransform(rec709_from_acescg()->createEditableCopy());
    if (entrance.primaries == Entrance::Primaries::kAces2065)
        group->appendTransform(aces2065_from_acescg());
    const auto shown = OCIO::DisplayViewTransform::Create();
    shown->setSrc(entrance.space);
    shown->setDisplay(display.c_str());
    shown->setView(view.c_str());
    group->appendTransform(shown);
    return config.getProcessor(group)->getDefaultCPUProcessor();
}

std::uint8_t byte_of(float value) {
    return static_cast<std::uint8_t>(
        value > 0.0f ? std::lround(std::min(value, 1.0f) * 255.0f) : 0);
}

}  // namespace

Rgb acescg_from_rec709(const Rgb& rec709) {
    return {dot(kAcesCgFromRec709[0], rec709), dot(kAcesCgFromRec709[1], rec709),
            dot(kAcesCgFromRec709[2], rec709)};
}

Rgb rec709_from_acescg(const Rgb& acescg) {
    return {dot(kRec709FromAcesCg[0], acescg), dot(kRec709FromAcesCg[1], acescg),
            dot(kRec709FromAcesCg[2], acescg)};
}

float luminance(const Rgb& acescg) {
    return dot({0.2722287f, 0.6740818f, 0.0536895f}, acescg);
}

struct Display::Transform {
    OCIO::ConstCPUProcessorRcPtr processor;
};

Display::Display(const ColourOptions& options) {
    const std::filesystem::path file = config_file(options);
    const auto config = read_config(file);
    const auto displays = displays_of(*config);
    display_ = chosen(file.string() + ": the display", options.display,
                      config->getDefaultDisplay(), displays);
    view_ = chosen(file.string() + ": the view", options.view,
                   config->getDefaultView(display_.c_str()), views_of(*config, display_));
    const Entrance entrance = entrance_of(*config, file);
    try {
        transform_ = std::make_unique<Transform>(
            Transform{processor_of(*config, entrance, display_, view_)});
    } catch (const OCIO::Exception& error) {  // a table file it names is missing
        refuse(file, error);
    }
}

Display::~Display() = default;

Rgb Display::shown(const Rgb& acescg) const {
    Rgb value = acescg;
    transform_->processor->applyRGB(value.data());
    return value;
}

Field<Rgb8> Display::shown(Field<Rgb> acescg) const {
    Field<Rgb8> result(acescg.width(), acescg.height());
    parallel_for(acescg.height(), [&](int y) {
        OCIO::PackedImageDesc row(acescg.row(y).data(), acescg.width(), 1, 3);
        transform_->processor->apply(row);
        std::transform(
            acescg.row(y).begin(), acescg.row(y).end(), result.row(y).begin(),
            [](const Rgb& value) {
                return Rgb8{byte_of(value[0]), byte_of(value[1]), byte_of(value[2])};
            });
    });
    return result;
}

}  // namespace cydonia::render
