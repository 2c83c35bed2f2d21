#pragma once

#include <optional>

#include "synth/texture/synthesis/pasting.h"
#include "synth/texture/synthesis/recording.h"

namespace cydonia::texture {

// Keeps one run coherent with the last one, and records it for the next (section 5.3).
class Keeping {
  public:
    // `guidance` is that of a run without coherence. `frozen` is where the last run's
    // land must stay.
    Keeping(const Guidance& guidance, std::optional<Run> last,
            std::optional<CellSet> frozen, const Controls& controls, int levels);

    // The land to keep, with its weights W: the last run's where the same is asked as
    // then. To be called once for each pass of each level.
    PinnedRegion pinned(const Window& window, int pass);

    Recording& passes() { return run_.passes; }
    // The finished run, to be stored for the next one. `database` is the key of the
    // database that it used.
    const Run& finished(std::uint64_t database);

  private:
    // Whether the cell, or its ancestor on the finest guided level, is asked for the same
    // as in the last run.
    bool same_asked(const Window& window, int x, int y) const;

    const Guidance& guidance_;
    std::optional<Run> last_;
    std::optional<CellSet> frozen_;
    int finest_guided_;
    Run run_;
    std::vector<Window> windows_;  // of run_.asked
};

}  // namespace cydonia::texture
