#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>

#include "app/pipeline/frame.h"
#include "app/sequence/sequence.h"

namespace cydonia {

// The lands of a sequence whose scene varies in time. A land is made for the first frame
// that draws it and exists while a frame holds its site; the one asked for last exists
// until the next. POV-Ray's files for it are in .cache/lands/. This must outlive the
// FrameLands that it returns.
class FilmLands {
  public:
    explicit FilmLands(const Job& job);

    // Removes files that killed runs left behind. If other processes share the folder,
    // only those of runs that traced the same frames.
    void remove_leftovers() const;

    // The land of a frame, which may be the job's own. Any thread may ask.
    FrameLand of(const SequenceFrame& frame);

  private:
    std::shared_ptr<const Site> site(Key key,
                                     std::shared_ptr<const config::SceneSpec> scene);

    const Job& job_;
    const Key own_;                       // of the job's own land
    const std::filesystem::path folder_;  // for POV-Ray's files
    std::mutex mutex_;                    // one land is made at a time, on all cores
    std::map<Key, std::weak_ptr<const Site>> sites_;
    std::shared_ptr<const Site> latest_;
};

}  // namespace cydonia
