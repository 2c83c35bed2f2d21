#pragma once

#include "app/pipeline/steps.h"

namespace cydonia {

inline constexpr int kManifestVersion = 1;  // of the file's form

// What the output folder holds and how it came about, enough to make it again:
// docs/manifest.md, config/schema/manifest.schema.json. Of the same scene everything is
// equal but "timings".
Json manifest_of(Graph& graph, const Job& job);

// Every key of a scene in canonical form, files by their content.
Json options_of(const config::SceneSpec& spec);

}  // namespace cydonia
