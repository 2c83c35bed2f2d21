#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "synth/context.h"

namespace cydonia {

// The files in which a stage of a scene remembers its last run. They stay until the
// scene's stage is of another method.
class StageMemory {
  public:
    // Of a stage whose land does not follow from them: one file.
    StageMemory(std::filesystem::path folder, int stage, const std::string& method);
    // Of one whose land does: one file a run, of the last two. A run that is made again
    // begins where it began the first time, so that it ends with the same land.
    StageMemory(std::filesystem::path folder, int stage, const std::string& method,
                std::uint64_t key);

    const Memory& files() const { return files_; }
    // Whether land that was made under this key is what the last run made: an older one
    // is not what the next run will find remembered.
    bool is_of_last_run() const { return key_ == last_; }
    // The run is over and its land is kept.
    void end_run();

  private:
    std::filesystem::path file_of(std::uint64_t key) const;

    std::filesystem::path folder_;
    std::string prefix_, name_;  // of this stage's files, of this method's
    bool one_file_;
    std::uint64_t key_ = 0, last_ = 0, before_ = 0;  // of runs; 0: none
    Memory files_;
};

// Of stages that the scene no longer has.
void forget_stages_after(const std::filesystem::path& folder, int stages);

}  // namespace cydonia
