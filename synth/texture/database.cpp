#include "synth/texture/database.h"

#include <algorithm>

#include "synth/texture/appearance.h"
#include "synth/texture/exemplars.h"
#include "synth/texture/matches.h"

namespace cydonia::texture {
namespace {

// One that is held in memory.
class MadeDatabase final : public Database {
  public:
    MadeDatabase(const Options& options, Progress& progress);

  private:
    std::vector<LevelArrays> pyramid_;
};

MadeDatabase::MadeDatabase(const Options& options, Progress& progress) {
    progress.step("texture: reading the exemplars");
    const Lands lands = lands_of(options, progress);
    spacing = lands.spacing;
    lowest = highest = lands.all.front().heights[0];
    for (const Land& land : lands.all) {
        names.push_back(land.name);
        const auto [low, high] = std::ranges::minmax(land.heights);
        lowest = std::min(lowest, low);
        highest = std::max(highest, high);
    }
    // No mode is further from 0 than half the range of heights.
    const HeightScale scale{0.5 * (double(lowest) + highest),
                            (double(highest) - lowest) / 60000.0};
    unit = scale.unit;

    progress.step("texture: searching the exemplars for places that look alike");
    pyramid_ = pyramid_of(lands.all, options.levels + 1);
    for (std::size_t i = pyramid_.size(); i-- > 0;) {
        LevelArrays& level = pyramid_[i];
        add_appearance(level, modes_of(level), scale);
        const double share = 0.75 / double(1u << (2 * i));
        add_matches(level, i + 1 < pyramid_.size() ? &pyramid_[i + 1] : nullptr,
                    options.orientations, progress, share / 3.0, share / 3.0 + share);
        sow(level, static_cast<int>(options.types.size()));
    }
    for (const LevelArrays& level : pyramid_) levels.push_back(level.view());
}

}  // namespace

std::uint64_t Database::cells() const {
    std::uint64_t sum = 0;
    if (!levels.empty())
        for (const Sheet& sheet : levels.front().sheets) sum += sheet.cells();
    return sum;
}

std::shared_ptr<const Database> database_of(const Options& options,
                                            const std::filesystem::path&,
                                            Progress& progress) {
    return std::make_shared<MadeDatabase>(options, progress);
}

}  // namespace cydonia::texture
