#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "app/pipeline/job.h"
#include "app/sequence/sequence.h"

namespace cydonia {

// The lands of a sequence whose scene varies in time. Frames of one land share it; it is
// made for the first of them and goes with the last.
class Sites {
  public:
    explicit Sites(Job& job);

    // What interrupted runs could not remove; beside other processes only of this one's
    // frames.
    void remove_leftovers();

    // Says in `frame` what scene and which land the shot is of. Any thread; holds as long
    // as this and the shot.
    void choose(const Shot& shot, FrameOf& frame);

  private:
    struct Own;
    std::string folder_prefix() const;
    std::shared_ptr<const Site> at(std::uint64_t key, const config::SceneSpec& scene);

    Job& job_;
    const std::uint64_t jobs_own_;  // the key of the job's land
    std::mutex mutex_;              // lands are made one at a time, on all cores
    std::map<std::uint64_t, std::weak_ptr<const Own>> made_;
    std::shared_ptr<const Own> latest_;
};

}  // namespace cydonia
