#include "app/describe.h"
#include "app/json.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/pipeline/memory.h"
#include "field/dem.h"
#include "field/error.h"
#include "field/files.h"
#include "field/packaged.h"
#include "field/svg.h"
#include "field/vec.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

// Steepest descent to the south and east neighbours, degrees, sorted.
std::vector<double> sorted_slopes(const Terrain& terrain) {
    const Field<float>& h = terrain.heights;
    std::vector<double> slopes;
    slopes.reserve(h.size());
    for (int y = 0; y + 1 < h.height(); ++y) {
        for (int x = 0; x + 1 < h.width(); ++x) {
            const double dx = h(x + 1, y) - h(x, y), dy = h(x, y + 1) - h(x, y);
            slopes.push_back(degrees(std::atan(std::hypot(dx, dy) / terrain.spacing)));
        }
    }
    std::ranges::sort(slopes);
    return slopes;
}

std::string heights_text(const fs::path& file) {
    std::string note;
    const Terrain terrain = read_dem(open_source(file), &note);
    const auto [low, high] = std::ranges::minmax_element(terrain.heights);
    std::string text = fmt::format(
        "{}: heights\n  {} x {} samples, {:g} m apart: {:g} x {:g} m\n  {:.1f} to {:.1f} "
        "m\n",
        file.string(), terrain.heights.width(), terrain.heights.height(), terrain.spacing,
        terrain.width(), terrain.depth(), *low, *high);
    if (const auto slopes = sorted_slopes(terrain); !slopes.empty()) {
        const auto at = [&](double share) {
            return slopes[static_cast<std::size_t>(
                share * static_cast<double>(slopes.size() - 1))];
        };
        text += fmt::format(
            "  slopes: half under {:.0f}, 90% under {:.0f}, 99% under {:.0f} degrees\n",
            at(0.5), at(0.9), at(0.99));
    }
    return note.empty() ? text : text + "  " + note + "\n";
}

std::string image_text(const fs::path& file, const OIIO::ImageSpec& spec) {
    std::string channels;
    for (const std::string& name : spec.channelnames) channels += " " + name;
    std::string text =
        fmt::format("{}: image\n  {} x {} pixels, {} of{}\n", file.string(), spec.width,
                    spec.height, spec.format.c_str(), channels);
    for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
        text += fmt::format("  {} = {}\n", attribute.name().string(),
                            attribute.get_string(16));
    }
    return text;
}

// "iou 0.931, precision 0.96": all figures of a step, nested ones too.
std::string figures_text(const Json& figures) {
    if (!figures.is_structured()) return figures.dump();
    std::string text;
    for (const auto& [name, value] : figures.items()) {
        if (name == "suns") continue;  // ten for each image; read them in the manifest
        if (!text.empty()) text += ", ";
        text +=
            figures.is_object() ? name + " " + figures_text(value) : figures_text(value);
    }
    return text;
}

std::string timings_text(const Json& timings) {
    std::string text;
    for (const auto& [step, seconds] : timings.at("seconds").items()) {
        text += fmt::format("  {:<28} {:8.2f} s\n", step, seconds.get<double>());
    }
    return text + fmt::format("  {:<28} {:>10}\n", "peak memory",
                              bytes_text(timings.at("peak_memory").get<std::uint64_t>()));
}

std::string manifest_text(const fs::path& file) try {
    const Json json = Json::parse(read_text(file));
    std::string text =
        fmt::format("{}: manifest of {}, {}\n", file.string(),
                    json.at("scene").get<std::string>(), json.at("title").dump());
    text += fmt::format("  seed {}, {} quality, {} outputs\n", json.at("seed").dump(),
                        json.at("quality").get<std::string>(), json.at("outputs").size());
    for (const auto& [step, figures] : json.at("figures").items()) {
        text += fmt::format("  {}: {}\n", step, figures_text(figures));
    }
    return text + timings_text(json.at("timings"));
} catch (const Json::exception&) {
    throw bad_request("{}: not a manifest of Cydonia", file.string());
}

// ", curves.svg, package:jacksboro": each file once, even if several keys name it.
std::string files_text(const std::vector<Source>& sources) {
    std::string text;
    std::set<fs::path> named;
    for (const Source& source : sources)
        if (named.insert(source.path).second)
            text += is_packaged_dem(source.path)
                        ? ", package:" + source.path.stem().string()
                        : ", " + source.name();
    return text;
}

// A file with one channel, such as terrain.exr, holds heights; an image has colours.
bool holds_heights(const fs::path& file, const OIIO::ImageSpec& spec) {
    const bool elevation_format = file.extension() == ".exr" ||
                                  file.extension() == ".tif" ||
                                  file.extension() == ".tiff";
    return spec.nchannels == 1 && elevation_format;
}

}  // namespace

std::string description(const config::SceneSpec& spec) {
    std::string text = fmt::format(
        "{}: {}\n  seed {}, {:g} x {:g} m, {} samples along the longer side{}\n",
        spec.name, spec.title, spec.seed, spec.terrain.width, spec.terrain.depth,
        spec.terrain.samples,
        spec.terrain.tiles > 0 ? fmt::format(", in tiles of {}", spec.terrain.tiles)
                               : "");
    for (const config::StageSpec& stage : spec.stages) {
        text += fmt::format("  stage: {}", method_of(stage.options).name);
        text += files_text(stage.sources) + "\n";
    }
    for (const render::CameraOptions& camera : spec.render.cameras) {
        text += fmt::format("  camera: {}, {} x {} pixels\n", camera.name, camera.size[0],
                            camera.size[1]);
    }
    return text;
}

std::string description(const fs::path& file) {
    const Source source = open_source(file);  // refuses missing, empty and huge files
    if (file.extension() == ".toml") {
        return description(config::Scene::load(file).at(0.0));
    }
    if (file.extension() == ".json") return manifest_text(file);
    if (is_svg(source)) return fmt::format("{}: a drawing (SVG)\n", file.string());
    if (const auto image = OIIO::ImageInput::open(file.string())) {
        if (!holds_heights(file, image->spec())) return image_text(file, image->spec());
    }
    OIIO::geterror();  // OIIO could not read it, but GDAL may
    return heights_text(file);
}

}  // namespace cydonia
