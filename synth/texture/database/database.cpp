#include "synth/texture/database/database.h"

#include <algorithm>

#include "field/error.h"
#include "field/files.h"
#include "synth/texture/database/appearance.h"
#include "synth/texture/database/database_file.h"
#include "synth/texture/database/exemplars.h"
#include "synth/texture/database/matches.h"

namespace cydonia::texture {
namespace {

constexpr std::uint64_t kMostKept = std::uint64_t{2} << 30;  // bytes of files in a cache

// A database that is held in memory.
class MadeDatabase final : public Database {
  public:
    MadeDatabase(const Options& options, Progress& progress);

  private:
    void describe(const Lands& lands);
    void add_pyramid(std::vector<Land> lands, const Options& options, Progress& progress);

    std::vector<LevelArrays> pyramid_;
};

MadeDatabase::MadeDatabase(const Options& options, Progress& progress) {
    progress.step("texture: reading the exemplars");
    Lands lands = lands_of(options, progress);
    describe(lands);
    progress.step("texture: searching the exemplars for similar places");
    add_pyramid(std::move(lands.all), options, progress);
}

void MadeDatabase::describe(const Lands& lands) {
    spacing = lands.spacing;
    lowest = highest = lands.all.front().heights[0];
    for (const Land& land : lands.all) {
        names.push_back(land.name);
        const auto [low, high] = std::ranges::minmax(land.heights);
        lowest = std::min(lowest, low);
        highest = std::max(highest, high);
    }
    // All modes fit into 16 bits, as none is farther from 0 than half the range of
    // heights.
    unit = (double(highest) - lowest) / 60000.0;
}

void refuse_landless(const LevelArrays& level, const std::vector<std::string>& names) {
    for (std::size_t e = 0; e < names.size(); ++e)
        if (places_of(level, level.sheets[e]) == 0)
            throw bad_request(
                "{}: its voids leave no 5x5 cells of land to take from it; "
                "fill the voids, or remove the exemplar",
                names[e]);
}

void MadeDatabase::add_pyramid(std::vector<Land> lands, const Options& options,
                               Progress& progress) {
    const HeightScale scale{0.5 * (double(lowest) + highest), unit};
    pyramid_ = pyramid_of(std::move(lands), options.levels + 1);
    refuse_landless(pyramid_.front(), names);
    for (std::size_t i = pyramid_.size(); i-- > 0;) {
        LevelArrays& level = pyramid_[i];
        add_appearance(level, modes_of(level), scale);
        const LevelArrays* coarser = i + 1 < pyramid_.size() ? &pyramid_[i + 1] : nullptr;
        const double share = 0.75 / double(std::uint64_t{1} << (2 * i));  // of the cells
        add_matches(level, coarser, options.orientations, progress, share / 3.0,
                    share / 3.0 + share);
        sow(level, static_cast<int>(options.types.size()));
    }
    for (const LevelArrays& level : pyramid_) levels.push_back(level.view());
}

// Writes a database to a file and returns it mapped from there, so that the system can
// reclaim its memory.
std::shared_ptr<const Database> kept(std::shared_ptr<const Database> made,
                                     const std::filesystem::path& cache,
                                     std::uint64_t key, Progress& progress) {
    const auto file = database_file(cache, key);
    try {
        make_folder(cache);
        write_database(file, key, *made, progress);
    } catch (const Error& error) {
        progress.warn(
            fmt::format("the database of the exemplars is not kept for the next run: {}",
                        error.what()));
        return made;
    }
    auto mapped = mapped_database(file, key);
    prune_databases(cache, kMostKept);
    return mapped ? mapped : made;
}

void warn_of_types_without_land(const Database& database, const Options& options,
                                Progress& progress) {
    const Level& level = database.levels.front();
    for (std::size_t t = 0; t < options.types.size(); ++t)
        if (level.seeds[t].empty())
            progress.warn(
                fmt::format("no exemplar has land of the type '{}'; paint it on one, or "
                            "remove the type",
                            options.types[t].name));
}

}  // namespace

std::uint64_t Database::cells() const {
    std::uint64_t sum = 0;
    if (!levels.empty())
        for (const Sheet& sheet : levels.front().sheets) sum += sheet.cells();
    return sum;
}

std::shared_ptr<const Database> database_of(const Options& options,
                                            const std::filesystem::path& cache,
                                            Progress& progress) {
    const std::uint64_t key = database_key(options);
    std::shared_ptr<const Database> database;
    if (!cache.empty()) database = mapped_database(database_file(cache, key), key);
    if (!database) {
        database = std::make_shared<MadeDatabase>(options, progress);
        if (!cache.empty()) database = kept(std::move(database), cache, key, progress);
    }
    warn_of_types_without_land(*database, options, progress);
    return database;
}

}  // namespace cydonia::texture
