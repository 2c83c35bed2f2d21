#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/pipeline/ledger.h"
#include "app/request.h"

namespace cydonia {

// A manifest.json as far as making its files again needs it.
struct ManifestFile {
    struct Output {
        std::string file;  // below the manifest's folder
        std::string xxh3;
    };

    std::filesystem::path folder;  // the manifest's own
    Request request;               // without an output folder
    std::vector<Goal> goals;
    std::vector<Output> outputs;
    Json json;
};

// Throws bad_request for what is no manifest, one of another version, values out of
// range, and outputs whose paths leave the folder.
ManifestFile read_manifest(const std::filesystem::path& file);

// Throws bad_request with every input that is missing or has changed, and every option
// that the scene reads otherwise now. Gives what is worth knowing besides: another build.
std::vector<std::string> check_inputs(const ManifestFile& manifest);

}  // namespace cydonia
