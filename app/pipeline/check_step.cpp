#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <variant>

#include "app/pipeline/memory.h"
#include "app/pipeline/shadow_report.h"
#include "app/pipeline/steps.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

// The heights before the first stage that hides an image; none if that is the first
// stage.
std::optional<Field<float>> base_of(const Job& job) {
    const auto& stages = job.spec->stages;
    const auto hides = [](const config::StageSpec& stage) {
        return std::holds_alternative<pareidolia::Options>(stage.options);
    };
    const auto before = std::ranges::find_if(stages, hides) - stages.begin();
    if (before == 0) return std::nullopt;
    return job.land.as_drawn(*job.land.get(static_cast<int>(before))).heights;
}

StepResult run_check(const Job& job) {
    StepResult made{{}, {{"images", Json::array()}}};
    if (job.land.finished()->shadows.empty()) return made;
    const auto base = base_of(job);
    const fs::path folder = job.folder / "shadow";
    const auto land = job.land.drawn();
    const CheckedShadows checked =
        check_shadows(*land, base ? &*base : nullptr, folder, job.progress);
    for (std::size_t i = 0; i < checked.reports.size(); ++i) {
        Json image = json_of(checked.reports[i]);
        image["figures"] = json_of(checked.figures[i]);
        made.result["images"].push_back(image);
    }
    for (const std::string& picture : shadow_pictures(*land))
        made.outputs.push_back("shadow/" + picture);
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

Step check_step(const Job& job) {
    const auto key = [&job] {
        const int factor = job.land.factor();
        return KeyBuilder("check")
            .add(job.program)
            .add(job.land.key())
            .add(factor)
            .add(factor > 1 ? job.spec->render_text : "")
            .key();
    };
    return {.id = kCheckStep,
            .memory = memory::of_check(job.drawn_cells()),
            .key = key,
            .run = [&job](Graph&) { return run_check(job); },
            .gate = [&job](const Json& result) { gate(result, job); }};
}

}  // namespace cydonia
