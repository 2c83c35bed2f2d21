#include "app/library_analyst.h"
#include "app/json.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/pipeline/key.h"
#include "app/pipeline/output_folder.h"
#include "field/dem.h"
#include "field/files.h"
#include "synth/statistics/segmentation.h"
#include "synth/statistics/water.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

using genetic::Example;
using statistics::Analysis;
using Mask = Field<std::uint8_t>;

constexpr double kFinest =
    0.75;  // of a model's spacing: the finest level it can be analysed at
constexpr int kTrimmed = 30;  // samples left out around voids

Json json_of(const Analysis& analysis) {
    Json all = Json::array();
    for (const statistics::Statistics& s : analysis)
        all.push_back({s.count, s.mean, s.deviation, s.skewness, s.kurtosis});
    return all;
}

Analysis analysis_from(const Json& all) {
    Analysis analysis;
    for (std::size_t q = 0; q < analysis.size(); ++q) {
        const Json& s = all.at(q);
        analysis[q] = {s.at(0).get<std::size_t>(), s.at(1).get<double>(),
                       s.at(2).get<double>(), s.at(3).get<double>(),
                       s.at(4).get<double>()};
    }
    return analysis;
}

// What `read` makes of the file's JSON; none if the file is missing or damaged.
template <class Read>
auto kept(const fs::path& file, const Read& read)
    -> std::optional<decltype(read(std::declval<const Json&>()))> {
    std::error_code none;
    if (!fs::exists(file, none)) return {};
    try {
        return read(Json::parse(read_text(file)));
    } catch (const Json::exception&) {
        return {};
    }
}

template <class T>
Field<T> part_of(const Field<T>& whole, const std::array<double, 4>& window) {
    if (whole.empty()) return {};
    const int w = whole.width(), h = whole.height();
    // At least one sample.
    const auto begin = [](double share, int n) {
        return std::min(int(share * n), n - 1);
    };
    const auto end = [](double share, int n) {
        return std::max(1, int(share * n + 0.5));
    };
    const int x0 = begin(window[0], w), x1 = std::max(x0 + 1, end(window[2], w)),
              y0 = begin(1.0 - window[3], h),
              y1 = std::max(y0 + 1, end(1.0 - window[1], h));
    Field<T> part(x1 - x0, y1 - y0);
    for (int y = y0; y < y1; ++y)
        std::copy_n(whole.row(y).begin() + x0, x1 - x0, part.row(y - y0).begin());
    return part;
}

Mask at_level(const Mask& mask, double cell, const Terrain& land) {
    if (std::ranges::find(mask, 1) == mask.end()) return {};
    return statistics::touched(mask, cell, land.heights.width(), land.heights.height());
}

double share_of(const Mask& mask) {
    if (mask.empty()) return 0.0;
    return double(std::ranges::count(mask, 1)) / double(mask.size());
}

}  // namespace

struct Analyst::Model {
    std::uint64_t hash;
    Terrain terrain;
    Mask voids, water;
};

Field<std::uint8_t> Studied::inside() const {
    if (voids.empty() && water.empty()) return {};
    Mask inside(terrain.heights.width(), terrain.heights.height(), 1);
    // The slope beside water is half the water's.
    const Mask shore = water.empty() ? Mask{} : statistics::grown(water, 1);
    for (std::size_t i = 0; i < inside.size(); ++i)
        if ((!voids.empty() && voids[i]) || (!shore.empty() && shore[i])) inside[i] = 0;
    return inside;
}

Analyst::Analyst(fs::path folder, Console& console)
    : folder_(std::move(folder)), console_(console) {
    make_folder(folder_);
}

fs::path Analyst::file_of(const char* what, const Example& example, double level) const {
    KeyBuilder key(what);
    key.add(statistics::kAnalysisVersion).add(example.source.hash);
    for (const auto side : example.window) key.add(side);
    key.add(level).add(example.scale).add(example.vertical_scale).add(example.raise);
    return folder_ / (hex(key.key()) + ".json");
}

const Analyst::Model& Analyst::model_of(const Source& source) {
    if (!model_ || model_->hash != source.hash) {
        console_.step("analysing " + source.name());
        model_ = std::make_shared<Model>();
        model_->hash = source.hash;
        model_->terrain = read_dem(source, nullptr, &model_->voids);
        model_->water = statistics::water_of(model_->terrain.heights);
        if (!model_->voids.empty())
            model_->voids = statistics::grown(model_->voids, kTrimmed);
    }
    return *model_;
}

std::optional<Studied> Analyst::studied(const Example& example, double level) {
    const Model& model = model_of(example.source);
    Terrain part;
    part.spacing = model.terrain.spacing * example.scale;
    if (level < kFinest * part.spacing) return {};
    part.heights = part_of(model.terrain.heights, example.window);
    for (float& height : part.heights)
        height = float(height * example.vertical_scale + example.raise);
    Studied studied;
    studied.terrain = statistics::at_level(part, level);
    const Terrain& land = studied.terrain;
    if (std::min(land.heights.width(), land.heights.height()) < kFewestSamples) return {};
    const double cell = level / part.spacing;
    studied.voids = at_level(part_of(model.voids, example.window), cell, land);
    studied.water = at_level(part_of(model.water, example.window), cell, land);
    return studied;
}

void Analyst::say_left_out(const Example& example, double voids, double water,
                           bool too_much) {
    if (!(voids > 0.0 || water > 0.0)) return;
    const auto& w = example.window;
    std::string name = example.source.name();
    if (w != Example{}.window)
        name += fmt::format(" [{:g}, {:g}, {:g}, {:g}]", w[0], w[1], w[2], w[3]);
    if (!said_.insert(fmt::format("{} {}", name, too_much)).second) return;
    std::string left_out;
    if (voids > 0.0)
        left_out = fmt::format("{:.1f}% that is at most {} samples from a void",
                               100.0 * voids, kTrimmed);
    if (water > 0.0)
        left_out += fmt::format("{}{:.1f}% under water", left_out.empty() ? "" : " and ",
                                100.0 * water);
    if (too_much)
        console_.warn(
            fmt::format("{}: of it {}, so that too little land is left to "
                        "analyse",
                        example.source.name(), left_out));
    else
        console_.note(fmt::format("{}: left out {}", example.source.name(), left_out));
}

std::optional<Analysis> Analyst::operator()(const Example& example, double level) {
    struct Kept {
        Analysis analysis{};  // an empty one is kept too
        double voids = 0.0, water = 0.0;
    };
    const fs::path file = file_of("analysis", example, level);
    auto found = kept(file, [](const Json& json) {
        return Kept{analysis_from(json.at("statistics")), json.at("voids").get<double>(),
                    json.at("water").get<double>()};
    });
    if (!found) {
        found.emplace();
        if (const auto studied = this->studied(example, level)) {
            found->voids = share_of(studied->voids);
            found->water = share_of(studied->water);
            const Mask inside = studied->inside();
            if (inside.empty())
                found->analysis = statistics::analysis_of(studied->terrain);
            else if (std::ranges::count(inside, 1) >= kFewestSamples * kFewestSamples)
                found->analysis = statistics::analysis_of(studied->terrain, inside);
        }
        write_text(file, Json{{"statistics", json_of(found->analysis)},
                              {"voids", found->voids},
                              {"water", found->water}}
                             .dump());
    }
    const bool none = found->analysis[0].count == 0;
    say_left_out(example, found->voids, found->water, none);
    if (none) return {};
    return found->analysis;
}

std::vector<Analysis> Analyst::windows(const Example& example, double level) {
    const fs::path file = file_of("windows", example, level);
    const auto found = kept(file, [](const Json& json) {
        std::vector<Analysis> all;
        for (const Json& one : json) all.push_back(analysis_from(one));
        return all;
    });
    if (found) return *found;
    std::vector<Analysis> all;
    if (const auto studied = this->studied(example, level))
        all = statistics::spread_windows(
            statistics::window_analyses(studied->terrain, studied->inside()));
    Json json = Json::array();
    for (const Analysis& one : all) json.push_back(json_of(one));
    write_text(file, json.dump());
    return all;
}

}  // namespace cydonia
