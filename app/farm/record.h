#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/pipeline/ledger.h"
#include "app/request.h"

namespace cydonia {

// The jobs that were submitted last: <output>/farm/farm.json.
struct FarmRecord {
    Request request;  // without scene and output
    Goal goal = Goal::kTurntable;
    // What each job does ("land", "frames", "collect") and its id, in order.
    std::vector<std::pair<std::string, std::string>> jobs;

    std::vector<std::string> ids() const;
};

std::filesystem::path farm_folder(const std::filesystem::path& output);
void write_record(const FarmRecord& record, const std::filesystem::path& output);
// Throws bad_request if there is none or it is damaged.
FarmRecord read_record(const std::filesystem::path& output);
bool has_record(const std::filesystem::path& output);

}  // namespace cydonia
