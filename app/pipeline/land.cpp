#include "app/pipeline/land.h"

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

constexpr std::uint64_t kCacheBytes = std::uint64_t{1} << 30;

int samples_across(double metres, double spacing) {
    return std::max(2, static_cast<int>(std::lround(metres / spacing)));
}

// The shadows that stages see are those of the mesh that will be rendered.
Field<std::uint8_t> cast(const Terrain& terrain, const Sun& sun, int rays) {
    const Field<float> heights = heights_of(quantised(terrain.heights));
    return render::Caster(heights, terrain.spacing).shadow(sun, rays);
}

std::uint64_t seed_of_stage(const config::SceneSpec& spec, int stage) {
    return hash_of({spec.seed, static_cast<std::uint64_t>(stage), key("stage")});
}

// Finer form would break a shadow image, unless the scene asks for it.
int factor_of(const config::SceneSpec& spec, int samples, render::Quality quality) {
    const render::FineReliefOptions& options = spec.render.fine_relief;
    const bool hides = std::ranges::any_of(spec.stages, [](const auto& stage) {
        return std::holds_alternative<pareidolia::Options>(stage.options);
    });
    if (hides && !options.factor) return 1;
    constexpr int kMost = 16384;  // samples a side of any land
    const int factor = render::fine_factor(options, samples, quality);
    if (factor > 1 && factor * samples > kMost)
        throw bad_request(
            "render.fine_relief: {} times {} samples a side are more than {}; lower "
            "factor",
            factor, samples, kMost);
    return factor;
}

std::uint64_t key_of_drawn(const render::FineReliefOptions& o, int factor,
                           std::uint64_t seed, std::uint64_t land) {
    return hash_text(fmt::format("fine {} {} {} {} {} {} {} {} {:016x}",
                                 render::kFineReliefVersion, factor, o.gullies, o.crags,
                                 o.terraces, o.step, o.craters, seed, land));
}

std::uint64_t key_of_stage(const config::StageSpec& stage, std::uint64_t before) {
    const Method method = method_of(stage.options);
    std::string text = fmt::format("{} {}\n{:016x}\n{}\n", method.name, method.version,
                                   before, stage.text);
    for (const Source& source : stage.sources)
        text += fmt::format("{:016x}\n", source.hash);
    return hash_text(text);
}

}  // namespace

Land::Land(const config::SceneSpec& spec, render::Quality quality, fs::path cache,
           Progress& progress)
    : spec_(spec), cache_(std::move(cache)), progress_(progress) {
    const config::TerrainSpec& t = spec.terrain;
    spacing_ = std::max(t.width, t.depth) / t.samples;
    width_ = samples_across(t.width, spacing_);
    height_ = samples_across(t.depth, spacing_);
    keys_ = {hash_text(
        fmt::format("flat {} {} {} seed {}", width_, height_, spacing_, spec.seed))};
    for (const config::StageSpec& stage : spec.stages) {
        keys_.push_back(key_of_stage(stage, keys_.back()));
    }
    factor_ = factor_of(spec, std::max(width_, height_), quality);
}

const Terrain& Land::after(int stage) {
    if (!terrain_ || stage_ != stage) {
        terrain_ = made(stage, nullptr);
        stage_ = stage;
    }
    return *terrain_;
}

const Terrain& Land::explained(int stage, const Explain& explain) {
    terrain_ = made(stage, &explain);
    stage_ = stage;
    return *terrain_;
}

std::uint64_t Land::drawn_key() const {
    return factor_ == 1
               ? key()
               : key_of_drawn(spec_.render.fine_relief, factor_, spec_.seed, key());
}

const Terrain& Land::drawn() {
    if (factor_ == 1) return finished();
    if (terrain_ && stage_ == stages() + 1) return *terrain_;
    const fs::path file = cached_terrain(cache_, drawn_key());
    auto drawn = load_terrain(file);
    if (!drawn) {
        drawn = as_drawn(finished());
        store_terrain(file, *drawn);
        prune_terrains(cache_, kCacheBytes);
    }
    terrain_ = std::move(*drawn);
    stage_ = stages() + 1;
    return *terrain_;
}

Terrain Land::as_drawn(const Terrain& terrain) const {
    return render::with_fine_relief(terrain, spec_.render.fine_relief, factor_,
                                    spec_.seed);
}

Terrain Land::made(int stage, const Explain* explain) {
    if (stage == 0) return {Field<float>(width_, height_), spacing_, {}, {}, {}};
    StageMemory memory = memory_of(stage);
    if (!explain && memory.is_of_last_run()) {
        if (auto terrain = load_terrain(cached(stage))) return std::move(*terrain);
    }
    make_folder(cache_);
    const config::StageSpec& spec = spec_.stages[static_cast<std::size_t>(stage - 1)];
    Terrain terrain = run(spec.options, after(stage - 1),
                          {.seed = seed_of_stage(spec_, stage - 1),
                           .cast = cast,
                           .progress = &progress_,
                           .explain = explain,
                           .memory = &memory.files(),
                           .cache = cache_});
    store_terrain(cached(stage), terrain);
    memory.end_run();
    forget_stages_after(cache_, stages());
    prune_terrains(cache_, kCacheBytes);
    return terrain;
}

StageMemory Land::memory_of(int stage) const {
    const StageOptions& options =
        spec_.stages[static_cast<std::size_t>(stage - 1)].options;
    const Method method = method_of(options);
    const std::string name(method.name);
    return method.follows_memory ? StageMemory(cache_, stage, name, key(stage))
                                 : StageMemory(cache_, stage, name);
}

Field<float> Land::tile(int x, int y, int width, int height, Progress& progress) const {
    const auto context = [&](int stage) -> Context {
        return {.seed = seed_of_stage(spec_, stage),
                .cast = cast,
                .progress = &progress,
                .cache = cache_};
    };
    const std::vector<const StageOptions*> stages = spec_.stage_options();
    return cydonia::tile(Stages(stages), {width_, height_, spacing_}, context, x, y,
                         width, height);
}

fs::path Land::cached(int stage) const { return cached_terrain(cache_, key(stage)); }

}  // namespace cydonia
