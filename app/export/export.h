#pragma once

#include <string>

#include "app/pipeline/steps.h"

namespace cydonia {

// The step of a request for an export: export/<scene>.<extension>, and beside it the same
// name with ".json" after it, which says what the file holds. Throws bad_request for
// values out of range.
Step export_file_step(const Job& job);

// One for each kind of format.
Step solid_step(const Job& job);
Step gltf_step(const Job& job);
Step heights_step(const Job& job);

// Which axes point where, for the ".json".
Json axes(const char* east, const char* north, const char* up);

// Writes the ".json" of a file in the job's folder; gives both as outputs, and what is in
// it as the result.
StepResult with_sidecar(const Job& job, const std::string& file, Json what);

// The samples asked for, or else `most` by default; of 2 to `most`.
int samples_of(const ExportRequest& asked, int by_default, int most);

}  // namespace cydonia
