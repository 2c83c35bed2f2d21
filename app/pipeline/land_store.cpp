#include "app/pipeline/land_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/pipeline/cache.h"
#include "field/error.h"
#include "field/files.h"
#include "field/quantise.h"
#include "field/random.h"
#include "render/fine_relief/fine_relief.h"
#include "render/shadow/caster.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

// Limit of the cache, which terrains that the scene needs next may exceed.
constexpr std::uint64_t kCacheBytes = std::uint64_t{1} << 30;

int samples_across(double metres, double spacing) {
    return std::max(2, static_cast<int>(std::lround(metres / spacing)));
}

// Stages get the shadows of the mesh that is rendered: its heights have 16 bits.
Field<std::uint8_t> cast(const Terrain& terrain, const Sun& sun, int rays) {
    const Field<float> heights = heights_of(quantised(terrain.heights));
    return render::Caster(heights, terrain.spacing).shadow(sun, rays);
}

std::uint64_t seed_of_stage(const config::SceneSpec& spec, int stage) {
    return hash_of({spec.seed, static_cast<std::uint64_t>(stage), key("stage")});
}

// Fine relief would disturb a shadow image, so land with one gets it only if the scene
// asks for it.
int factor_of(const config::SceneSpec& spec, int samples, render::Quality quality) {
    const render::FineReliefOptions& options = spec.render.fine_relief;
    const bool hides = std::ranges::any_of(spec.stages, [](const auto& stage) {
        return std::holds_alternative<pareidolia::Options>(stage.options);
    });
    if (hides && !options.factor) return 1;
    const int factor = render::fine_factor(options, samples, quality);
    if (factor > 1 && factor * samples > kLargestSide)
        throw bad_request(
            "render.fine_relief: {} times {} samples a side are more than {}; lower "
            "factor",
            factor, samples, kLargestSide);
    return factor;
}

Key key_of_drawn(const render::FineReliefOptions& o, int factor, std::uint64_t seed,
                 Key land) {
    return KeyBuilder("drawn land")
        .add(render::kFineReliefVersion)
        .add(factor)
        .add(o.gullies)
        .add(o.crags)
        .add(o.terraces)
        .add(o.step)
        .add(o.craters)
        .add(seed)
        .add(land)
        .key();
}

Key key_of_stage(const config::StageSpec& stage, Key before) {
    const Method method = method_of(stage.options);
    KeyBuilder key("stage");
    key.add(method.name).add(method.version).add(before).add(stage.text);
    for (const Source& source : stage.sources) key.add(source.hash);
    return key.key();
}

}  // namespace

LandStore::LandStore(std::shared_ptr<const config::SceneSpec> scene,
                     render::Quality quality, fs::path cache, Progress& progress)
    : scene_(std::move(scene)),
      quality_(quality),
      cache_(std::move(cache)),
      progress_(progress) {
    const config::TerrainSpec& t = scene_->terrain;
    spacing_ = std::max(t.width, t.depth) / t.samples;
    width_ = samples_across(t.width, spacing_);
    height_ = samples_across(t.depth, spacing_);
    keys_ = {KeyBuilder("flat land")
                 .add(width_)
                 .add(height_)
                 .add(spacing_)
                 .add(scene_->seed)
                 .key()};
    for (const config::StageSpec& stage : scene_->stages)
        keys_.push_back(key_of_stage(stage, keys_.back()));
    factor_ = factor_of(*scene_, std::max(width_, height_), quality);
}

Key LandStore::drawn_key() const {
    return factor_ == 1
               ? key()
               : key_of_drawn(scene_->render.fine_relief, factor_, scene_->seed, key());
}

LandStore::Handle LandStore::get(int stage) const {
    const std::scoped_lock lock(mutex_);
    return locked_get(stage);
}

LandStore::Handle LandStore::drawn() const {
    const std::scoped_lock lock(mutex_);
    return locked_get(factor_ == 1 ? stages() : stages() + 1);
}

std::shared_ptr<const render::LandMaps> LandStore::maps() const {
    const std::scoped_lock lock(mutex_);
    if (maps_) return maps_;
    const Handle land = locked_get(factor_ == 1 ? stages() : stages() + 1);
    auto maps = render::land_maps(*land, scene_->render.ground, quality_);
    maps.ground.albedo = {};
    return maps_ = std::make_shared<const render::LandMaps>(std::move(maps));
}

LandStore::Handle LandStore::explained(int stage, const Explain& explain) const {
    const std::scoped_lock lock(mutex_);
    latest_ = std::make_shared<const Terrain>(locked_make(stage, &explain));
    held_[stage] = latest_;
    return latest_;
}

LandStore::Handle LandStore::locked_get(int number) const {
    if (Handle held = held_[number].lock()) return latest_ = std::move(held);
    latest_ = std::make_shared<const Terrain>(
        number > stages() ? locked_draw() : locked_make(number, nullptr));
    held_[number] = latest_;
    return latest_;
}

Terrain LandStore::locked_make(int stage, const Explain* explain) const {
    if (stage == 0) return {Field<float>(width_, height_), spacing_, {}, {}, {}};
    StageMemory memory = memory_of(stage);
    if (!explain && memory.is_of_last_run()) {
        if (auto terrain = load_terrain(cached(stage))) return std::move(*terrain);
    }
    make_folder(cache_);
    const config::StageSpec& spec = scene_->stages[static_cast<std::size_t>(stage - 1)];
    const Handle before = locked_get(stage - 1);
    Terrain terrain = run(spec.options, *before,
                          {.seed = seed_of_stage(*scene_, stage - 1),
                           .cast = cast,
                           .progress = &progress_,
                           .explain = explain,
                           .memory = &memory.files(),
                           .cache = cache_});
    store(stage, terrain);
    memory.end_run();
    forget_stages_after(cache_, stages());
    return terrain;
}

Terrain LandStore::locked_draw() const {
    const int number = stages() + 1;
    if (auto terrain = load_terrain(cached(number))) return std::move(*terrain);
    Terrain terrain = as_drawn(*locked_get(stages()));
    store(number, terrain);
    return terrain;
}

// The terrain before this one, the finished and the drawn one stay in the cache however
// large they are: otherwise the next step would make them again.
void LandStore::store(int number, const Terrain& terrain) const {
    store_terrain(cached(number), terrain);
    std::vector<fs::path> kept{cached(stages()), cached(stages() + 1)};
    if (number > 1) kept.push_back(cached(number - 1));
    prune_terrains(cache_, kCacheBytes, kept);
}

Terrain LandStore::as_drawn(const Terrain& terrain) const {
    return render::with_fine_relief(terrain, scene_->render.fine_relief, factor_,
                                    scene_->seed);
}

StageMemory LandStore::memory_of(int stage) const {
    const StageOptions& options =
        scene_->stages[static_cast<std::size_t>(stage - 1)].options;
    const Method method = method_of(options);
    const std::string name(method.name);
    return method.follows_memory ? StageMemory(cache_, stage, name, key(stage))
                                 : StageMemory(cache_, stage, name);
}

Field<float> LandStore::tile(int x, int y, int width, int height,
                             Progress& progress) const {
    const auto context = [&](int stage) -> Context {
        return {.seed = seed_of_stage(*scene_, stage),
                .cast = cast,
                .progress = &progress,
                .cache = cache_};
    };
    const std::vector<const StageOptions*> stages = scene_->stage_options();
    return cydonia::tile(Stages(stages), {width_, height_, spacing_}, context, x, y,
                         width, height);
}

fs::path LandStore::cached(int number) const {
    return cached_terrain(cache_, number > stages() ? drawn_key() : key(number));
}

}  // namespace cydonia
