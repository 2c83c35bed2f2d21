#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>

#include "app/pipeline/frame.h"
#include "app/sequence/sequence.h"

namespace cydonia {

// The lands of a sequence whose scene varies in time. A land is made for the first frame
// that draws it, shared by all that do, and gone with the last, but for the one that was
// asked for last. POV-Ray's files of it stand in .cache/lands/ meanwhile. Must outlive
// the frames that it was asked for.
class FilmLands {
  public:
    explicit FilmLands(const Job& job);

    // Removes what killed runs left behind; beside other processes, only those that
    // traced the same frames.
    void remove_leftovers() const;

    // The land of a frame: the job's own where that is the same. Any thread.
    FrameLand of(const SequenceFrame& frame);

  private:
    std::shared_ptr<const Site> site(Key key,
                                     std::shared_ptr<const config::SceneSpec> scene);

    const Job& job_;
    const Key own_;                       // of the job's land
    const std::filesystem::path folder_;  // for the files of these frames' lands
    std::mutex mutex_;                    // lands are made one at a time, on all cores
    std::map<Key, std::weak_ptr<const Site>> sites_;
    std::shared_ptr<const Site> latest_;
};

}  // namespace cydonia
