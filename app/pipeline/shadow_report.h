#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/pipeline/ledger.h"
#include "field/error.h"
#include "field/sun.h"
#include "render/shadow/check.h"

namespace cydonia {

// Shadow reports in the ledger and the manifest. Angles there are in degrees.
Json json_of(const Sun& sun);
Sun sun_of(const Json& json);
Json json_of(const render::ShadowReport& report);
render::ShadowReport report_of(const Json& json);
// All figures, for the manifest; docs/shadow-check.md explains them.
Json json_of(const render::ShadowFigures& figures);

// "text: IoU 0.931 (at least 0.85), precision 0.960, recall 0.969"
std::string score_text(const render::ShadowReport& report);
// "text: IoU 0.929 under the sun's whole disc; stands out by 14.2 deviations (3 are ...)"
std::string figures_text(const std::string& name, const render::ShadowFigures& figures);

// Checks the shadows and measures all figures. `base` are the heights before an image was
// hidden in them, or null if not known. Writes pictures to `folder` and notes the scores.
struct CheckedShadows {
    std::vector<render::ShadowReport> reports;
    std::vector<render::ShadowFigures> figures;
};
CheckedShadows check_shadows(const Terrain& terrain, const Field<float>* base,
                             const std::filesystem::path& folder, Progress& progress);

// The pictures that check_shadows() writes, relative to `folder`.
std::vector<std::string> shadow_pictures(const Terrain& terrain);

// Throws Error with ExitCode::kCheckFellShort, scores and advice if any image fell short.
// `folder` holds the pictures.
void stop_when_short(const std::vector<render::ShadowReport>& reports,
                     const std::filesystem::path& folder);

}  // namespace cydonia
