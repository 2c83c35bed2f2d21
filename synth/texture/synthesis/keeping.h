#pragma once

#include <optional>

#include "synth/texture/synthesis/pasting.h"
#include "synth/texture/synthesis/recording.h"

namespace cydonia::texture {

// One run that keeps to the last one and is itself recorded (section 5.3).
class Keeping {
  public:
    // `guidance` without coherence. `frozen`: where the last run's land must stay; none:
    // nowhere.
    Keeping(const Guidance& guidance, std::optional<Run> last,
            std::optional<Region> frozen, const Controls& controls, int levels);

    // W and what it is of: the last run's land is kept to where the same is asked as
    // then. Called once for every pass of every level.
    Kept kept(const Window& window, int pass);

    Recording& passes() { return run_.passes; }
    // The run, for the next one; `database` is whose places it holds.
    const Run& finished(std::uint64_t database);

  private:
    // The asked-for number of a cell's ancestor on the finest level that is guided.
    bool same_asked(const Window& window, int x, int y) const;

    const Guidance& guidance_;
    std::optional<Run> last_;
    std::optional<Region> frozen_;
    int finest_guided_;
    Run run_;
    std::vector<Window> windows_;  // of run_.asked
};

}  // namespace cydonia::texture
