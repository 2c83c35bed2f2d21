#include "app/pipeline/shadow_report.h"

#include <fmt/core.h>

#include <cmath>

namespace fs = std::filesystem;

namespace cydonia {
namespace {

// 0.9412, not 0.94117647058823528.
double rounded(double value) { return std::round(value * 1e4) / 1e4; }

Json json_of(const render::LandFigures& land) {
    return {{"range", rounded(land.range)},
            {"slope_99", rounded(land.slope)},
            {"laplacian_kurtosis", rounded(land.kurtosis)}};
}

Json json_of(const render::Trace& trace) {
    return {{"correlation", rounded(trace.correlation)},
            {"outline", rounded(trace.outline)},
            {"standing_out", rounded(trace.standing_out)}};
}

Json json_of(const render::OtherSun& other) {
    Json json = {{"sun", json_of(other.sun)}, {"land", json_of(other.land)}};
    if (other.base) json["base"] = json_of(*other.base);
    return json;
}

// Less the base's own where there is one.
Json hidden(const render::ShadowFigures& figures) {
    Json json = {{"correlation_raised", rounded(hiddenness(figures, 0.0))},
                 {"outline", rounded(outline_ratio(figures))},
                 {"standing_out", rounded(worst_standing_out(figures))},
                 {"suns", Json::array()}};
    for (const int turned : {10, 30, 45, 90, 180})
        json[fmt::format("correlation_{}", turned)] =
            rounded(hiddenness(figures, turned));
    for (const render::OtherSun& other : figures.other_suns)
        json["suns"].push_back(json_of(other));
    return json;
}

}  // namespace

Json json_of(const render::ShadowFigures& figures) {
    Json json = {{"iou_4x4", rounded(figures.iou_4x4)},
                 {"iou_1x1", rounded(figures.iou_1x1)},
                 {"iou_frame", rounded(figures.iou_frame)},
                 {"iou_soft", rounded(figures.iou_soft)},
                 {"outline_f", rounded(figures.outline)},
                 {"standing_out", rounded(figures.standing_out)},
                 {"given_up", rounded(figures.relaxed.share)},
                 {"iou_bound", rounded(figures.relaxed.bound)},
                 {"other_suns", hidden(figures)},
                 {"land", json_of(figures.land)}};
    if (figures.thin_recall) json["thin_recall"] = rounded(*figures.thin_recall);
    if (figures.base) json["base"] = json_of(*figures.base);
    return json;
}

Json json_of(const render::ShadowReport& report) {
    Json json = {{"name", report.name},           {"sun", json_of(report.sun)},
                 {"iou", report.score.iou},       {"precision", report.score.precision},
                 {"recall", report.score.recall}, {"min_iou", report.min_iou},
                 {"given_up", report.relaxed},    {"rival", report.rival}};
    if (report.standing_out) json["standing_out"] = *report.standing_out;
    return json;
}

render::ShadowReport report_of(const Json& json) {
    render::ShadowReport report;
    report.name = json.at("name");
    report.sun = sun_of(json.at("sun"));
    report.score = {json.at("iou"), json.at("precision"), json.at("recall")};
    report.min_iou = json.at("min_iou");
    report.relaxed = json.at("given_up");
    report.rival = json.at("rival");
    if (json.contains("standing_out")) report.standing_out = json["standing_out"];
    return report;
}

Json json_of(const Sun& sun) {
    // 215, not 215.00000000000003.
    const auto plain = [](double angle) {
        return std::round(degrees(angle) * 1e9) / 1e9;
    };
    return {{"azimuth", plain(sun.azimuth)}, {"elevation", plain(sun.elevation)}};
}

Sun sun_of(const Json& json) {
    return {radians(json.at("azimuth")), radians(json.at("elevation"))};
}

std::string score_text(const render::ShadowReport& report) {
    // 0.8498 is not "0.850 (at least 0.85)".
    const double iou = report.score.iou;
    const double shown = iou >= report.min_iou ? iou : std::floor(iou * 1000.0) / 1000.0;
    std::string text = fmt::format(
        "{}: IoU {:.3f} (at least {:.2f}), precision {:.3f}, recall {:.3f}", report.name,
        shown, report.min_iou, report.score.precision, report.score.recall);
    if (report.relaxed > 0.0)
        text +=
            fmt::format("; {:.1f}% of its cells gave way to {}", 100.0 * report.relaxed,
                        report.rival.empty() ? "other images" : report.rival);
    return text;
}

std::string figures_text(const std::string& name, const render::ShadowFigures& figures) {
    std::string text = fmt::format(
        "{}: stands out by {:.1f} deviations under its sun, by {:.1f} at most under "
        "others; correlation {} {:.2f} with the sun turned by 30 degrees, {:.2f} by 90",
        name, figures.standing_out, worst_standing_out(figures),
        figures.base ? "away from the base's" : "of its own", hiddenness(figures, 30.0),
        hiddenness(figures, 90.0));
    if (!figures.base) return text;
    const auto times = [](double land, double base) {
        return base > 0.0 ? land / base : 1.0;
    };
    return text + fmt::format("; slopes {:.2f}x, relief {:.2f}x the base's",
                              times(figures.land.slope, figures.base->slope),
                              times(figures.land.range, figures.base->range));
}

CheckedShadows check_shadows(const Terrain& terrain, const Field<float>* base,
                             const fs::path& folder, Progress& progress) {
    CheckedShadows checked;
    checked.reports = render::check(terrain, folder);
    for (const auto& report : checked.reports) progress.note(score_text(report));
    checked.figures = render::measure(terrain, base, folder, progress);
    for (std::size_t i = 0; i < checked.reports.size(); ++i) {
        checked.reports[i].standing_out = checked.figures[i].standing_out;
        progress.note(figures_text(checked.reports[i].name, checked.figures[i]));
    }
    return checked;
}

std::vector<std::string> shadow_pictures(const Terrain& terrain) {
    std::vector<std::string> pictures;
    for (const ShadowImage& image : terrain.shadows) {
        const std::string folder = terrain.shadows.size() == 1 ? "" : image.name + "/";
        for (const char* name :
             {"cast.png", "target.png", "overlay.png", "sun-clock.png"})
            pictures.push_back(folder + name);
        if (!image.window.empty()) pictures.push_back(folder + "window.png");
    }
    return pictures;
}

void stop_when_short(const std::vector<render::ShadowReport>& reports,
                     const fs::path& folder) {
    std::string message;
    for (const render::ShadowReport& report : reports) {
        if (report.passed()) continue;
        message += render::advice(report) + "\n";
    }
    if (message.empty()) return;
    throw Error(
        ExitCode::kCheckFellShort,
        fmt::format("the shadows fall short of what the scene asks for\n{}look at {}",
                    message, folder.string()));
}

}  // namespace cydonia
