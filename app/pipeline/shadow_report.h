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

// "text: IoU 0.931 (at least 0.85), precision 0.960, recall 0.969"
std::string score_text(const render::ShadowReport& report);

// Throws Error with ExitCode::kCheckFellShort, scores and advice when any image fell
// short; `folder` holds the pictures.
void stop_when_short(const std::vector<render::ShadowReport>& reports,
                     const std::filesystem::path& folder);

}  // namespace cydonia
