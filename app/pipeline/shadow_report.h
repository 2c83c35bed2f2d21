#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/pipeline/ledger.h"
#include "field/error.h"
#include "field/sun.h"
#include "render/shadow/check.h"

namespace cydonia {

// Shadow reports as the ledger and the manifest keep them; angles in degrees.
Json json_of(const Sun& sun);
Sun sun_of(const Json& json);
Json json_of(const render::ShadowReport& report);
render::ShadowReport report_of(const Json& json);
// All figures, for the manifest; what docs/shadow-check.md explains.
Json json_of(const render::ShadowFigures& figures);

// "text: IoU 0.931 (at least 0.85), precision 0.960, recall 0.969"
std::string score_text(const render::ShadowReport& report);
// "text: IoU 0.929 under the sun's whole disc; stands out by 14.2 deviations (3 are ...)"
std::string figures_text(const std::string& name, const render::ShadowFigures& figures);

// Checks the shadows, measures all figures against `base` (heights before the land was
// bent; null: not known) and writes both into `folder` and the log. The reports carry
// how far each image stands out.
struct CheckedShadows {
    std::vector<render::ShadowReport> reports;
    std::vector<render::ShadowFigures> figures;
};
CheckedShadows check_shadows(const Terrain& terrain, const Field<float>* base,
                             const std::filesystem::path& folder, Progress& progress);

// The pictures that these checks write, below `folder`.
std::vector<std::string> shadow_pictures(const Terrain& terrain);

// Throws Error with ExitCode::kCheckFellShort, scores and advice when any image fell
// short; `folder` holds the pictures.
void stop_when_short(const std::vector<render::ShadowReport>& reports,
                     const std::filesystem::path& folder);

}  // namespace cydonia
