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

std::filesystem::path config_file(const ColourOptions& options) {
    if (options.config) return options.config->path;
    if (const char* named = std::getenv("OCIO"); named && *named) return named;
    return data_file("ocio/config.ocio");
}

// Joins the lines of a message of OpenColorIO.
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

// The chosen name, or the default when none is chosen.
std::string chosen(const std::string& what, const std::string& wish,
                   const std::string& otherwise, const std::vector<std::string>& names) {
    const std::string& choice = wish.empty() ? otherwise : wish;
    if (std::find(names.begin(), names.end(), choice) != names.end()) return choice;
    throw bad_request("{} '{}' is unknown; there is: {}", what, choice,
                      fmt::format("{}", fmt::join(names, ", ")));
}

// The colour space in which frames enter. Configs have many names for ACEScg and linear
// Rec.709.
struct Entrance {
    const char* space;
    enum class Primaries { kAcesCg, kRec709, kAces2065 } primaries;
};

Entrance entrance_of(const OCIO::Config& config, const std::filesystem::path& file) {
    using enum Entrance::Primaries;
    for (const char* name : {"ACEScg", "ACES - ACEScg", "lin_ap1"})
        if (config.getColorSpace(name)) return {name, kAcesCg};
    // OpenColorIO 2 has a role for this purpose.
    for (const char* name : {"aces_interchange", "ACES2065-1", "ACES - ACES2065-1"})
        if (config.getColorSpace(name)) return {name, kAces2065};
    // The configs of Blender and Nuke call linear Rec.709 just "linear".
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

OCIO::ConstTransformRcPtr to_rec709() {
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
        group->appendTransform(to_rec709()->createEditableCopy());
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

float luminance(const Rgb& acescg) {
    return 0.2722287f * acescg[0] + 0.6740818f * acescg[1] + 0.0536895f * acescg[2];
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
    } catch (const OCIO::Exception& error) {  // a file that the config names is missing
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
