#include "app/pipeline/shadow_report.h"

#include <fmt/core.h>

#include <cmath>

namespace fs = std::filesystem;

namespace cydonia {

Json json_of(const render::ShadowReport& report) {
    return {{"name", report.name},           {"sun", json_of(report.sun)},
            {"iou", report.score.iou},       {"precision", report.score.precision},
            {"recall", report.score.recall}, {"min_iou", report.min_iou}};
}

render::ShadowReport report_of(const Json& json) {
    render::ShadowReport report;
    report.name = json.at("name");
    report.sun = sun_of(json.at("sun"));
    report.score = {json.at("iou"), json.at("precision"), json.at("recall")};
    report.min_iou = json.at("min_iou");
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
    const double shown = report.passed() ? iou : std::floor(iou * 1000.0) / 1000.0;
    return fmt::format(
        "{}: IoU {:.3f} (at least {:.2f}), precision {:.3f}, recall {:.3f}", report.name,
        shown, report.min_iou, report.score.precision, report.score.recall);
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
