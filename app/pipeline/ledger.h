#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "app/json.h"
#include "app/pipeline/key.h"

namespace cydonia {

// What a finished step left behind.
struct StepRecord {
    Key key = 0;                            // of everything that went into the step
    std::vector<std::string> outputs = {};  // files, relative to the output folder
    std::vector<std::uint64_t> sizes = {};  // of the outputs, bytes
    Json result = Json::object();           // what the step measured or chose
    double seconds = 0.0;
    std::uint64_t peak_memory = 0;           // bytes
    std::vector<std::uint64_t> hashes = {};  // of the outputs' bytes; 0: too large a file
    std::vector<std::int64_t> written = {};  // their times of modification
};

// The finished steps of an output folder, kept in its .cache so that an interrupted or
// repeated run does nothing twice. The file has one line of JSON for each record and is
// appended to. The last line of a step counts; a line that a killed run left incomplete
// is ignored. Any thread may ask and record. A record stays valid until its step is
// recorded again.
class Ledger {
  public:
    // Reads the folder's ledger. If it is missing or damaged, it counts as empty.
    explicit Ledger(const std::filesystem::path& output_folder);

    // Reads the ledger again, because another process may have worked in the folder.
    void reload();

    // Whether the step was ever recorded.
    bool has(const std::string& step) const;

    // The step's record if it has this key and all its files are unchanged. A file with
    // another time of modification is hashed again.
    const StepRecord* finished(const std::string& step, Key key) const;

    // The files that the step made when it last ran.
    std::vector<std::string> outputs_of(const std::string& step) const;

    // Adds a finished step. Removes files that its last run made and this one did not.
    // Throws failure() if the step has written one file twice.
    const StepRecord& record(const std::string& step, StepRecord record);

    // From now on records go to a file of this process, so that processes that share the
    // folder do not overwrite each other's. A process that has the folder to itself
    // merges these files with its first record.
    void record_apart(const std::string& name);

  private:
    void append(const std::string& step, const StepRecord& record);
    void rewrite();

    std::filesystem::path folder_;
    mutable std::mutex mutex_;
    std::map<std::string, StepRecord> records_;
    std::filesystem::path file_;                // where records are appended
    bool is_apart_ = false;                     // file_ is this process's own
    std::vector<std::filesystem::path> apart_;  // files of other processes, to be merged
    bool is_worn_ = false;  // a line is incomplete, or most no longer count
};

}  // namespace cydonia
