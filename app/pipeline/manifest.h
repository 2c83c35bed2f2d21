#pragma once

#include "app/pipeline/steps.h"

namespace cydonia {

inline constexpr int kManifestVersion = 1;  // of the file format

// Describes the files of the output folder and everything needed to make them again:
// docs/manifest.md, config/schema/manifest.schema.json. The same scene gives the same
// manifest but for "timings".
Json manifest_of(Graph& graph, const Job& job);

// Every key of a scene in canonical form, with files given by their content.
Json options_of(const config::SceneSpec& spec);

}  // namespace cydonia
