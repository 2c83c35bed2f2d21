#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/pipeline/ledger.h"
#include "app/request.h"

namespace cydonia {

// What was handed in to a farm last: <output>/farm/farm.json.
struct FarmRecord {
    Request request;  // without scene and output
    Goal goal = Goal::kTurntable;
    // Job ids by what they do: "land", "frames", "collect", in their order.
    std::vector<std::pair<std::string, std::string>> jobs;

    std::vector<std::string> ids() const;
};

std::filesystem::path farm_folder(const std::filesystem::path& output);
void write_record(const FarmRecord& record, const std::filesystem::path& output);
// Throws bad_request where none is, or a damaged one.
FarmRecord read_record(const std::filesystem::path& output);
bool has_record(const std::filesystem::path& output);

}  // namespace cydonia
