#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "app/pipeline/stage_memory.h"
#include "config/reader/scene.h"
#include "field/progress.h"
#include "field/terrain.h"
#include "synth/context.h"

namespace cydonia {

// A scene's terrain, made stage by stage when it is asked for; what a stage made before
// comes from the cache.
class Land {
  public:
    Land(const config::SceneSpec& spec, render::Quality quality,
         std::filesystem::path cache, Progress& progress);

    int stages() const { return static_cast<int>(spec_.stages.size()); }
    int width() const { return width_; }  // samples, west to east
    int height() const { return height_; }
    double spacing() const { return spacing_; }  // metres
    int factor() const { return factor_; }       // samples of the drawn land a sample

    // A hash of everything that the land after `stage` stages is made from.
    std::uint64_t key(int stage) const { return keys_[static_cast<std::size_t>(stage)]; }
    std::uint64_t key() const { return keys_.back(); }
    std::uint64_t drawn_key() const;  // likewise of the land as it is drawn

    // The land after `stage` stages (0: flat). The reference holds until the next call.
    const Terrain& after(int stage);
    const Terrain& finished() { return after(stages()); }
    // The finished land as it is checked and drawn, with form finer than its samples
    // (render/fine_relief). The reference holds until the next call.
    const Terrain& drawn();
    // Any land of this scene drawn like it.
    Terrain as_drawn(const Terrain& terrain) const;
    // The same, made anew, so that the stage shows how it came to it.
    const Terrain& explained(int stage, const Explain& explain);

    // Of a land in tiles: width x height of its heights, from column x and row y on.
    Field<float> tile(int x, int y, int width, int height, Progress& progress) const;

  private:
    // Without `explain` from the cache, if it is there.
    Terrain made(int stage, const Explain* explain);
    StageMemory memory_of(int stage) const;
    std::filesystem::path cached(int stage) const;

    const config::SceneSpec& spec_;
    std::filesystem::path cache_;
    Progress& progress_;
    int width_, height_;
    double spacing_;
    int factor_;
    std::vector<std::uint64_t> keys_;
    std::optional<Terrain> terrain_;  // after stage_ stages
    int stage_ = 0;                   // stages() + 1: the drawn land
};

}  // namespace cydonia
