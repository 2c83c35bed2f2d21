#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "app/cache.h"
#include "app/check.h"
#include "app/job.h"
#include "app/memory.h"

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
    return {{"azimuth", degrees(sun.azimuth)}, {"elevation", degrees(sun.elevation)}};
}

Sun sun_of(const Json& json) {
    return {radians(json.at("azimuth")), radians(json.at("elevation"))};
}

std::string score_text(const render::ShadowReport& report) {
    return fmt::format(
        "{}: IoU {:.3f} (at least {:.2f}), precision {:.3f}, recall {:.3f}", report.name,
        report.score.iou, report.min_iou, report.score.precision, report.score.recall);
}

void stop_when_short(const std::vector<render::ShadowReport>& reports,
                     const fs::path& folder) {
    std::string message;
    for (const render::ShadowReport& report : reports) {
        if (report.passed()) continue;
        message += fmt::format("{}\n{}\n", score_text(report), render::advice(report));
    }
    if (message.empty()) return;
    throw Error(
        ExitCode::kCheckFellShort,
        fmt::format("the shadows fall short of what the scene asks for\n{}look at {}",
                    message, folder.string()));
}

namespace {

// Where render::check put them.
std::vector<std::string> pictures_of(const render::ShadowReport& report, bool alone) {
    const std::string folder = alone ? "shadow/" : "shadow/" + report.name + "/";
    return {folder + "cast.png", folder + "target.png", folder + "overlay.png"};
}

Made check_shadows(Job& job) {
    Made made{{}, {{"images", Json::array()}}};
    const Terrain& terrain = job.land.finished();
    if (terrain.shadows.empty()) return made;
    const auto reports = render::check(terrain, job.folder / "shadow", job.progress);
    for (const render::ShadowReport& report : reports) {
        job.progress.note(score_text(report));
        made.result["images"].push_back(json_of(report));
        std::ranges::copy(pictures_of(report, reports.size() == 1),
                          std::back_inserter(made.outputs));
    }
    return made;
}

void gate(const Json& result, const Job& job) {
    std::vector<render::ShadowReport> reports;
    for (const Json& image : result.at("images")) reports.push_back(report_of(image));
    if (!job.request.force) return stop_when_short(reports, job.folder / "shadow");
    for (const render::ShadowReport& report : reports) {
        if (!report.passed()) job.progress.warn(score_text(report) + "; --force goes on");
    }
}

}  // namespace

Step check_step(Job& job) {
    return {
        "check",
        Goal::kCheck,
        memory::of_check(job.cells()),
        [&job] {
            return hash_text(fmt::format("{:016x} {:016x}", job.land.key(), job.program));
        },
        [&job] { return check_shadows(job); },
        [&job](const Json& result) { gate(result, job); }};
}

}  // namespace cydonia
