#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/pipeline/ledger.h"
#include "app/request.h"

namespace cydonia {

// What is needed of a manifest.json to make its files again.
struct ManifestFile {
    struct Output {
        std::string file;  // relative to the manifest's folder
        std::string xxh3;
    };

    std::filesystem::path folder;  // of the manifest
    Request request;               // without an output folder
    std::vector<Goal> goals;
    std::vector<Output> outputs;
    Json json;
};

// Throws bad_request for a file that is no manifest, for one of another version, values
// out of range, and outputs outside its folder.
ManifestFile read_manifest(const std::filesystem::path& file);

// Throws bad_request that lists every input that is missing or has changed, and every
// option that the scene reads differently now. Returns notes: that the build is another.
std::vector<std::string> check_inputs(const ManifestFile& manifest);

}  // namespace cydonia
