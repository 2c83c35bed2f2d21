#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "app/pipeline/cache.h"
#include "app/pipeline/job.h"
#include "app/pipeline/memory.h"
#include "app/pipeline/shadow_report.h"

namespace fs = std::filesystem;

namespace cydonia {

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
