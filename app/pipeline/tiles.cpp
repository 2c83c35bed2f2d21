#include "app/pipeline/tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <system_error>

#include "app/pipeline/memory.h"
#include "app/pipeline/output_folder.h"
#include "app/threads.h"
#include "field/error.h"
#include "field/files.h"
#include "field/tiled.h"
#include "render/maps/hillshade.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

constexpr const char* kFolder = "tiles";

struct Tile {
    int column, row;
    int x, y, width, height;  // samples
};

struct Grid {
    int width, height, side;  // samples

    int columns() const { return (width + side - 1) / side; }
    int rows() const { return (height + side - 1) / side; }
    Tile at(int column, int row) const {
        const int x = column * side, y = row * side;
        return {column, row, x, y, std::min(side, width - x), std::min(side, height - y)};
    }
    template <class Visit>
    void for_all(const Visit& visit) const {
        for (int row = 0; row < rows(); ++row)
            for (int column = 0; column < columns(); ++column) visit(at(column, row));
    }
};

Grid grid_of(const Job& job) {
    return {job.land.width(), job.land.height(), job.spec->terrain.tiles};
}

fs::path file_of(const Job& job, const Tile& tile) {
    return job.folder / kFolder / fmt::format("tile-{}-{}.tif", tile.column, tile.row);
}

// The key that is stored in a tile's file.
std::string key_of(const Job& job, const Tile& tile) {
    return hex(KeyBuilder("tile").add(job.land.key()).add(tile.x).add(tile.y).key());
}

TiledShape shape_of(const Job& job) {
    return {job.land.width(), job.land.height(), job.land.spacing()};
}

bool is_made(const Job& job, const Tile& tile) {
    return holds_tile(file_of(job, tile), tile.width, tile.height, key_of(job, tile));
}

Field<float> made(const Job& job, const Tile& tile, Progress& progress) {
    Field<float> heights =
        job.land.tile(tile.x, tile.y, tile.width, tile.height, progress);
    make_folder(job.folder / kFolder);
    write_tile(file_of(job, tile), heights, tile.x, tile.y, shape_of(job),
               key_of(job, tile));
    return heights;
}

Field<float> read_or_made(const Job& job, const Tile& tile, Progress& progress) {
    if (auto heights =
            read_tile(file_of(job, tile), tile.width, tile.height, key_of(job, tile)))
        return std::move(*heights);
    return made(job, tile, progress);
}

// One bar for all tiles. A sentence that several tiles say is shown once.
class TilesProgress final : public Progress {
  public:
    TilesProgress(Progress& sink, int tiles) : sink_(sink), tiles_(tiles) {}

    void finished_one() { report_all(++finished_); }
    void step(std::string_view) override {}
    void report(double) override { report_all(finished_); }
    void note(std::string_view sentence) override {
        if (said_.emplace(sentence).second) sink_.note(sentence);
    }
    void warn(std::string_view sentence) override {
        if (said_.emplace(sentence).second) sink_.warn(sentence);
    }

  private:
    void report_all(int finished) { sink_.report(double(finished) / tiles_); }

    Progress& sink_;
    int tiles_, finished_ = 0;
    std::set<std::string, std::less<>> said_;
};

// The whole land, averaged to few enough samples for a picture.
class Overview {
  public:
    explicit Overview(const TiledShape& shape) : shape_(shape) {
        constexpr int kMost = 2048;
        while (std::max(shape.width, shape.height) > kMost * factor_) factor_ *= 2;
        land_.heights = Field<float>((shape.width + factor_ - 1) / factor_,
                                     (shape.height + factor_ - 1) / factor_);
        land_.spacing = shape.spacing * factor_;
    }
    void add(const Tile& tile, const Field<float>& heights) {
        for (int y = 0; y < tile.height; ++y)
            for (int x = 0; x < tile.width; ++x) {
                const float height = heights(x, y);
                lowest = std::min(lowest, height);
                highest = std::max(highest, height);
                const int i = (tile.x + x) / factor_, j = (tile.y + y) / factor_;
                land_.heights(i, j) += height / static_cast<float>(samples_in(i, j));
            }
    }
    Field<Rgb8> picture() const { return render::hillshade(land_); }

    float lowest = std::numeric_limits<float>::infinity();
    float highest = -std::numeric_limits<float>::infinity();

  private:
    int samples_in(int i, int j) const {
        return std::min(factor_, shape_.width - i * factor_) *
               std::min(factor_, shape_.height - j * factor_);
    }
    TiledShape shape_;
    int factor_ = 1;
    Terrain land_;
};

// Removes what killed processes or a land with more tiles left behind. No other process
// works in the folder.
void clear_leftovers(const Job& job) {
    const auto is_temporary = [](const fs::path& file) {
        const std::string name = file.filename().string();
        return name.starts_with('.') && name.find(".tmp") != name.npos;
    };
    const Grid grid = grid_of(job);
    std::set<fs::path> ours;
    grid.for_all([&](const Tile& tile) { ours.insert(file_of(job, tile)); });
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(job.folder / kFolder, none)) {
        const std::string name = entry.path().filename().string();
        if (is_temporary(entry) ||
            (name.starts_with("tile-") && !ours.contains(entry.path())))
            fs::remove(entry, none);
    }
    for (const auto& entry : fs::directory_iterator(job.folder, none))
        if (is_temporary(entry)) fs::remove(entry, none);
}

Overview put_together(const Job& job, const fs::path& tif, const fs::path& exr) {
    const Grid grid = grid_of(job);
    Metadata metadata = job.metadata();
    metadata["cydonia:spacing"] = fmt::format("{}", job.land.spacing());
    const auto into_tif = tiled_geotiff(tif, shape_of(job));
    const auto into_exr = tiled_exr(exr, shape_of(job), metadata);
    Overview overview(shape_of(job));
    TilesProgress progress(job.progress, grid.columns() * grid.rows());
    grid.for_all([&](const Tile& tile) {
        const Field<float> heights = read_or_made(job, tile, progress);
        into_tif->write(tile.x, tile.y, heights);
        into_exr->write(tile.x, tile.y, heights);
        overview.add(tile, heights);
        progress.finished_one();
    });
    into_tif->close();
    into_exr->close();
    return overview;
}

StepResult make_terrain(const Job& job) {
    clear_leftovers(job);
    Json result;
    write_atomically(job.folder / "terrain.tif", [&](const fs::path& tif) {
        write_atomically(job.folder / "terrain.exr", [&](const fs::path& exr) {
            const Overview overview = put_together(job, tif, exr);
            write_png(job.folder / "preview.png", overview.picture());
            const auto [width, height, spacing] = shape_of(job);
            result = {{"samples", {width, height}},
                      {"spacing", spacing},
                      {"extent", {width * spacing, height * spacing}},
                      {"lowest", overview.lowest},
                      {"highest", overview.highest},
                      {"tiles", {grid_of(job).columns(), grid_of(job).rows()}}};
        });
    });
    return {{"terrain.exr", "terrain.tif", "preview.png"}, result};
}

std::uint64_t memory_of(const Job& job) {
    const Grid grid = grid_of(job);
    const Tile largest = grid.at(0, 0);
    return memory::of_tile(job.spec->stage_options(),
                           {job.land.width(), job.land.height(), job.land.spacing()},
                           largest.width, largest.height,
                           static_cast<std::uint64_t>(thread_count()));
}

}  // namespace

void check_request(const Job& job, Goal goal) {
    const Request& request = job.request;
    if (job.spec->terrain.tiles == 0) {
        if (!request.tile) return;
        throw bad_request("--tile: {} has no tiles; give [terrain] tiles = 2048",
                          request.scene.string());
    }
    if (goal != Goal::kTerrain || request.export_as || request.explain)
        throw bad_request(
            "land in tiles is made by synth, and no more is done with it; for the same "
            "land whole and smaller: --set terrain.tiles=0 --set terrain.samples=2048");
    if (!request.tile) return;
    const Grid grid = grid_of(job);
    const auto [column, row] = *request.tile;
    if (column < 0 || row < 0 || column >= grid.columns() || row >= grid.rows())
        throw bad_request("--tile {},{}: the land has tiles 0,0 to {},{}", column, row,
                          grid.columns() - 1, grid.rows() - 1);
}

Step tiles_step(const Job& job) {
    const auto key = [&job] {
        return KeyBuilder("tiles")
            .add(job.program)
            .add(job.land.key())
            .add(job.spec->name)
            .add(job.spec->terrain.tiles)
            .key();
    };
    return {
        .id = kExportStep, .memory = memory_of(job), .key = key, .run = [&job](Graph&) {
            return make_terrain(job);
        }};
}

void make_tile(const Job& job) {
    const auto [column, row] = *job.request.tile;
    const Tile tile = grid_of(job).at(column, row);
    if (is_made(job, tile))
        return job.progress.note(fmt::format("tile {},{} exists already", column, row));
    memory::refuse_unless_it_fits(memory_of(job), memory::available());
    const OutputFolder claim(job.folder, OutputFolder::Claim::kShared);
    made(job, tile, job.progress);
}

std::string tiles_text(const Job& job) {
    const Grid grid = grid_of(job);
    int made = 0;
    grid.for_all([&](const Tile& tile) { made += is_made(job, tile); });
    return fmt::format("{} x {} tiles, {} of {} made", grid.columns(), grid.rows(), made,
                       grid.columns() * grid.rows());
}

}  // namespace cydonia
