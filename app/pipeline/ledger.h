#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace cydonia {

using Json = nlohmann::ordered_json;

// What a finished step left behind.
struct Entry {
    std::uint64_t key = 0;  // a hash of everything that went into the step
    std::vector<std::string> outputs = {};  // relative to the output folder
    std::vector<std::uint64_t> sizes = {};  // of the outputs, bytes
    Json result = Json::object();           // what the step learned
    double seconds = 0.0;
    std::uint64_t peak_memory = 0;           // bytes
    std::vector<std::uint64_t> hashes = {};  // of the outputs' bytes
    std::vector<std::int64_t> written = {};  // when they were, as the file system counts
};

// Which steps are finished in an output folder, kept in its .cache so that an interrupted
// or repeated run does nothing twice. Any thread may ask and record; an entry belongs to
// who works on its step.
class Ledger {
  public:
    // A missing or damaged ledger is an empty one.
    explicit Ledger(const std::filesystem::path& output_folder);

    // The step's entry if it was made from the same inputs and all its files are still
    // there, whole: one that was written since is read again.
    const Entry* finished(const std::string& step, std::uint64_t key) const;

    // The files that the step made when it last ran.
    std::vector<std::string> outputs_of(const std::string& step) const;

    // Sets down a finished step; files that its last run made and this one did not are
    // removed.
    const Entry& record(const std::string& step, Entry entry);

    // From now on what is recorded goes to a file of its own, so that processes that
    // share the folder do not lose each other's steps. The next record of one that has
    // the folder alone takes all such files in.
    void record_apart(const std::string& name);

  private:
    void write() const;

    std::filesystem::path folder_;
    std::unique_ptr<std::mutex> mutex_ = std::make_unique<std::mutex>();
    std::map<std::string, Entry> entries_;
    std::vector<std::filesystem::path> apart_;  // other files that were read
    std::filesystem::path own_file_;            // empty: the folder's
    std::set<std::string> own_;                 // the steps in it
};

std::string hex(std::uint64_t key);

}  // namespace cydonia
