#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/pipeline/key.h"

namespace cydonia {

using Json = nlohmann::ordered_json;

// What a finished step left behind.
struct StepRecord {
    Key key = 0;                            // of everything that went into the step
    std::vector<std::string> outputs = {};  // files, relative to the output folder
    std::vector<std::uint64_t> sizes = {};  // of the outputs, bytes
    Json result = Json::object();           // what the step measured or chose
    double seconds = 0.0;
    std::uint64_t peak_memory = 0;           // bytes
    std::vector<std::uint64_t> hashes = {};  // of the outputs' bytes; 0: too large a file
    std::vector<std::int64_t> written = {};  // when they were, as the file system counts
};

// Which steps are finished in an output folder, kept in its .cache so that an interrupted
// or repeated run does nothing twice. The file has a line of JSON for every record and is
// only appended to; of a step's lines the last counts, and a line that a killed run left
// unfinished does not. Any thread may ask and record; a record may be read until its own
// step is recorded again.
class Ledger {
  public:
    // Reads what there is. A missing or damaged ledger is an empty one.
    explicit Ledger(const std::filesystem::path& output_folder);

    // Reads it again: another process may have been at work in the folder.
    void reload();

    // Whether the step was ever recorded.
    bool has(const std::string& step) const;

    // The step's record if it was made under this key and all its files are still there,
    // whole: one that was written since is hashed again.
    const StepRecord* finished(const std::string& step, Key key) const;

    // The files that the step made when it last ran.
    std::vector<std::string> outputs_of(const std::string& step) const;

    // Adds a finished step; files that its last run made and this one did not are
    // removed. Throws failure() where two of its outputs are one file.
    const StepRecord& record(const std::string& step, StepRecord record);

    // From now on records go to a file of their own, so that processes that share the
    // folder do not lose each other's steps. The next record of a process that has the
    // folder alone takes all such files in.
    void record_apart(const std::string& name);

  private:
    void append(const std::string& step, const StepRecord& record);
    void rewrite();

    std::filesystem::path folder_;
    mutable std::mutex mutex_;
    std::map<std::string, StepRecord> records_;
    std::filesystem::path file_;                // that records go to
    bool is_apart_ = false;                     // it is this process's own
    std::vector<std::filesystem::path> apart_;  // files of other processes
    bool is_worn_ = false;  // the file is torn, or most of its lines count no more
};

}  // namespace cydonia
