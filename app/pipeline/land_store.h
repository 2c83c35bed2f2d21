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
#include "render/scene/land_maps.h"
#include "synth/context.h"

namespace cydonia {

// The terrains of one scene: after each stage, and as it is drawn. A terrain is read from
// the cache on disk or made when it is first asked for, and stays in memory while anybody
// holds it. The store itself holds the one that was asked for last. Any thread may ask;
// one terrain is made at a time, on all cores.
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
    int factor() const { return factor_; }  // samples of the drawn land for each sample

    // Keys of the land after `stage` stages, the finished land and the drawn land.
    Key key(int stage) const { return keys_[static_cast<std::size_t>(stage)]; }
    Key key() const { return keys_.back(); }
    Key drawn_key() const;

    // The land after `stage` stages. After 0 it is flat.
    Handle get(int stage) const;
    Handle finished() const { return get(stages()); }
    // The finished land as it is checked and drawn: with relief finer than its samples
    // where the scene has any (render/fine_relief).
    Handle drawn() const;
    // The maps of the drawn land without the albedo, which is large and only emitted.
    std::shared_ptr<const render::LandMaps> maps() const;
    // Makes the land after `stage` stages even if it is cached, so that the stage can
    // explain how it does.
    Handle explained(int stage, const Explain& explain) const;

    // Adds to a land of this scene the fine relief that drawn() has.
    Terrain as_drawn(const Terrain& terrain) const;

    // Makes width x height heights of a land in tiles, from column x and row y on.
    Field<float> tile(int x, int y, int width, int height, Progress& progress) const;

  private:
    // These are called with mutex_ locked. The drawn land is number stages() + 1.
    Handle locked_get(int number) const;
    Terrain locked_make(int stage, const Explain* explain) const;
    Terrain locked_draw() const;
    void store(int number, const Terrain& terrain) const;

    StageMemory memory_of(int stage) const;
    std::filesystem::path cached(int number) const;

    std::shared_ptr<const config::SceneSpec> scene_;
    render::Quality quality_;
    std::filesystem::path cache_;
    Progress& progress_;
    int width_, height_;
    double spacing_;
    int factor_;
    std::vector<Key> keys_;

    mutable std::mutex mutex_;  // guards what follows; held while a terrain is made
    mutable std::map<int, std::weak_ptr<const Terrain>> held_;
    mutable Handle latest_;
    mutable std::shared_ptr<const render::LandMaps> maps_;
};

}  // namespace cydonia
