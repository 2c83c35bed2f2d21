#include "app/pipeline/land.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/pipeline/cache.h"
#include "field/files.h"
#include "field/quantise.h"
#include "field/random.h"
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

// A stage's memory of its last run: one file, replaced each time.
Memory memory_in(const fs::path& file) {
    constexpr std::size_t kMostBytes = std::size_t{512} << 20;
    return {[file] {
                std::error_code none;
                const std::uintmax_t size = fs::file_size(file, none);
                if (none || size > kMostBytes) return std::string();
                return read_text(file, kMostBytes);
            },
            [file](const std::string& bytes) {
                make_folder(file.parent_path());
                write_text(file, bytes);
            }};
}

std::uint64_t seed_of_stage(const config::SceneSpec& spec, int stage) {
    return hash_of({spec.seed, static_cast<std::uint64_t>(stage), key("stage")});
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

Land::Land(const config::SceneSpec& spec, fs::path cache, Progress& progress)
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

Terrain Land::made(int stage, const Explain* explain) {
    if (stage == 0) return {Field<float>(width_, height_), spacing_, {}, {}, {}};
    if (!explain) {
        if (auto terrain = load_terrain(cached(stage))) return std::move(*terrain);
    }
    const config::StageSpec& spec = spec_.stages[static_cast<std::size_t>(stage - 1)];
    const Memory memory = memory_in(cache_ / fmt::format("stage-{}.passes", stage));
    Terrain terrain = run(spec.options, after(stage - 1),
                          {.seed = seed_of_stage(spec_, stage - 1),
                           .cast = cast,
                           .progress = &progress_,
                           .explain = explain,
                           .memory = &memory,
                           .cache = cache_});
    store_terrain(cached(stage), terrain);
    prune_terrains(cache_, kCacheBytes);
    return terrain;
}

Field<float> Land::tile(int x, int y, int width, int height, Progress& progress) const {
    const config::StageSpec& spec = spec_.stages.front();
    return cydonia::tile(spec.options, {width_, height_, spacing_},
                         {.seed = seed_of_stage(spec_, 0),
                          .cast = cast,
                          .progress = &progress,
                          .cache = cache_},
                         x, y, width, height);
}

fs::path Land::cached(int stage) const { return cached_terrain(cache_, key(stage)); }

}  // namespace cydonia
