#pragma once

#include <string>

#include "app/pipeline/steps.h"

namespace cydonia {

// Writes export/<scene>.<extension> as the request asks, and beside it a file with
// ".json" added to its name that describes it. Throws bad_request for values out of
// range.
Step export_file_step(const Job& job);

// The same for each kind of format.
Step solid_step(const Job& job);
Step gltf_step(const Job& job);
Step heights_step(const Job& job);

// Where the axes point, for the ".json".
Json axes(const char* east, const char* north, const char* up);

// Writes the ".json" of a file in the job's folder. Both files are the outputs, `what` is
// the result.
StepResult with_sidecar(const Job& job, const std::string& file, Json what);

// The samples asked for, else `by_default`. Throws bad_request if not 2 to `most`.
int samples_of(const ExportRequest& asked, int by_default, int most);

}  // namespace cydonia
