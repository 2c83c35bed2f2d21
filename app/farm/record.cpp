#include "app/farm/record.h"

#include <algorithm>

#include "app/request_json.h"
#include "field/error.h"
#include "field/files.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

fs::path file_in(const fs::path& output) { return farm_folder(output) / "farm.json"; }

// Ids become arguments of Slurm's programs: only digits are accepted.
std::string checked_id(const std::string& id) {
    if (id.empty() ||
        !std::ranges::all_of(id, [](char c) { return '0' <= c && c <= '9'; }))
        throw bad_request("'{}' is not the id of a job", id);
    return id;
}

}  // namespace

std::vector<std::string> FarmRecord::ids() const {
    std::vector<std::string> ids;
    for (const auto& [what, id] : jobs) ids.push_back(id);
    return ids;
}

fs::path farm_folder(const fs::path& output) { return output / "farm"; }

void write_record(const FarmRecord& record, const fs::path& output) {
    Json jobs = Json::object();
    for (const auto& [what, id] : record.jobs) jobs[what] = id;
    const Json json = {{"command", json_of(Command{{record.goal}, record.request})},
                       {"force", record.request.force},
                       {"jobs", jobs}};
    write_text(file_in(output), json.dump(1) + "\n");
}

FarmRecord read_record(const fs::path& output) {
    const fs::path file = file_in(output);
    if (!has_record(output))
        throw bad_request("{}: no jobs were submitted; cydonia farm submits them",
                          output.string());
    try {
        const Json json = Json::parse(read_text(file));
        Command command = command_of(json.at("command"));
        FarmRecord record{std::move(command.request), command.goals.at(0), {}};
        record.request.force = json.at("force");
        for (const auto& [what, id] : json.at("jobs").items())
            record.jobs.emplace_back(what, checked_id(id.get<std::string>()));
        return record;
    } catch (const Error& error) {
        throw bad_request("{}: {}", file.string(), error.what());
    } catch (const std::exception&) {
        throw bad_request("{}: damaged; cydonia farm writes a new one", file.string());
    }
}

bool has_record(const fs::path& output) {
    std::error_code none;
    return fs::is_regular_file(file_in(output), none);
}

}  // namespace cydonia
