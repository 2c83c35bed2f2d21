#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "synth/context.h"

namespace cydonia {

// The files in which a stage of a scene keeps what it remembers of its last run. They are
// removed when the stage gets another method.
class StageMemory {
  public:
    // One file, for a stage whose land does not depend on what it remembers.
    StageMemory(std::filesystem::path folder, int stage, const std::string& method);
    // For a stage whose land depends on it: a file for each of the last two runs. The
    // last run, if made again, starts from the same file as before and gives the same
    // land.
    StageMemory(std::filesystem::path folder, int stage, const std::string& method,
                std::uint64_t key);

    const Memory& files() const { return files_; }
    // Whether the last run had this key. Land of an older run does not match what the
    // next run would remember.
    bool is_of_last_run() const { return key_ == last_; }
    // Tells that the run is over and its land is stored.
    void end_run();

  private:
    std::filesystem::path file_of(std::uint64_t key) const;

    std::filesystem::path folder_;
    std::string prefix_, name_;  // of the files of the stage, and of its method
    bool one_file_;
    std::uint64_t key_ = 0, last_ = 0, before_ = 0;  // of runs; 0 if there is none
    Memory files_;
};

// Removes the files of stages that the scene no longer has.
void forget_stages_after(const std::filesystem::path& folder, int stages);

}  // namespace cydonia
