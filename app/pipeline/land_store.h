#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "app/pipeline/key.h"
#include "app/pipeline/stage_memory.h"
#include "config/reader/scene.h"
#include "field/progress.h"
#include "field/terrain.h"
#include "synth/context.h"

namespace cydonia {

// The terrains of one scene: after each stage, and as it is drawn. One is made when it is
// first asked for, from the one before or from the cache on disk, and stays in memory
// while anybody holds it; the store itself holds the one that was asked for last. Any
// thread may ask; terrains are made one at a time, each on all cores.
class LandStore {
  public:
    using Handle = std::shared_ptr<const Terrain>;

    // Terrains are kept in the folder `cache`.
    LandStore(std::shared_ptr<const config::SceneSpec> scene, render::Quality quality,
              std::filesystem::path cache, Progress& progress);

    int stages() const { return static_cast<int>(scene_->stages.size()); }
    int width() const { return width_; }  // samples, west to east
    int height() const { return height_; }
    double spacing() const { return spacing_; }  // metres
    int factor() const { return factor_; }       // samples of the drawn land a sample

    // Of the land after `stage` stages, from 0 on; of the finished one; of the drawn one.
    Key key(int stage) const { return keys_[static_cast<std::size_t>(stage)]; }
    Key key() const { return keys_.back(); }
    Key drawn_key() const;

    // The land after `stage` stages; 0: flat.
    Handle get(int stage) const;
    Handle finished() const { return get(stages()); }
    // The finished land as it is checked and drawn, with form finer than its samples
    // (render/fine_relief).
    Handle drawn() const;
    // Makes the land after `stage` stages anew, so that the stage shows how it does.
    Handle explained(int stage, const Explain& explain) const;

    // Any land of this scene with the finer form that drawn() has.
    Terrain as_drawn(const Terrain& terrain) const;

    // Of a land in tiles: width x height of its heights, from column x and row y on.
    Field<float> tile(int x, int y, int width, int height, Progress& progress) const;

  private:
    // Those with this name are called with mutex_ locked. The drawn land has the number
    // after the last stage's.
    Handle locked_get(int number) const;
    Terrain locked_make(int stage, const Explain* explain) const;
    Terrain locked_draw() const;
    void store(int number, const Terrain& terrain) const;

    StageMemory memory_of(int stage) const;
    std::filesystem::path cached(int number) const;

    std::shared_ptr<const config::SceneSpec> scene_;
    std::filesystem::path cache_;
    Progress& progress_;
    int width_, height_;
    double spacing_;
    int factor_;
    std::vector<Key> keys_;

    mutable std::mutex mutex_;  // of what follows, and while a terrain is made
    mutable std::map<int, std::weak_ptr<const Terrain>> held_;
    mutable Handle latest_;
};

}  // namespace cydonia
