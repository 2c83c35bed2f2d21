#include "app/pipeline/memory.h"

#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

#include "field/dem.h"
#include "field/error.h"
#include "field/image.h"

namespace cydonia {
namespace {

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kMega = 1'000'000;
constexpr std::uint64_t kProgram = 175 * kMega;  // code, libraries, thread pools
constexpr std::uint64_t kPasses = 268 * kMega;   // remembered of a stage, at most
constexpr std::uint64_t kMostModel = std::uint64_t{16384} * 16384;  // cells
constexpr std::uint64_t kPovray = 40 * kMega;                       // the same of POV-Ray

// The number in one of the kernel's accounting files; kUnlimited if it has none ("max").
std::uint64_t number_in(const char* file) {
    std::uint64_t value = 0;
    return std::ifstream(file) >> value ? value : kUnlimited;
}

std::uint64_t machine_available() {
    std::ifstream meminfo("/proc/meminfo");
    std::string name;
    std::uint64_t kibibytes = 0;
    for (std::string line; std::getline(meminfo, line);) {
        std::istringstream fields(line);
        if (fields >> name >> kibibytes && name == "MemAvailable:")
            return kibibytes * 1024;
    }
    return kUnlimited;
}

// The limits of a container, in control groups of versions 2 and 1.
std::uint64_t group_available() {
    const auto left = [](std::uint64_t limit, std::uint64_t used) {
        if (limit == kUnlimited || used == kUnlimited) return kUnlimited;
        return limit - std::min(limit, used);
    };
    return std::min(left(number_in("/sys/fs/cgroup/memory.max"),
                         number_in("/sys/fs/cgroup/memory.current")),
                    left(number_in("/sys/fs/cgroup/memory/memory.limit_in_bytes"),
                         number_in("/sys/fs/cgroup/memory/memory.usage_in_bytes")));
}

std::uint64_t address_space_limit() {
    rlimit limit = {};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) {
        return kUnlimited;
    }
    return limit.rlim_cur;
}

// The ground's picture has up to four pixels a cell side, 4096 a side at most.
std::uint64_t ground_pixels(std::uint64_t cells) {
    return std::max(cells, std::min(16 * cells, std::uint64_t{4096} * 4096));
}

std::uint64_t exemplar_cells(const texture::Options& options) {
    std::uint64_t cells = 0;
    for (const texture::Exemplar& e : options.exemplars)
        cells += std::min(kMostModel, samples_of_dem(e.source).value_or(e.source.size));
    return cells;
}

// A picture's own pixels, and those that a drawing or two tones of it are drawn with.
std::uint64_t of_image(const pareidolia::ImageOptions& image, std::uint64_t cells) {
    constexpr std::uint64_t kFinest = std::uint64_t{4096} * 4096;
    const std::uint64_t own = image.target ? pixels_of(*image.target) : 0;
    const std::uint64_t drawn = own > 0 ? own : 16 * cells;
    return 8 * own + 20 * std::min(drawn, kFinest) + 16 * cells;
}

}  // namespace

namespace memory {

std::uint64_t of_stage(const StageOptions& options, std::uint64_t cells,
                       std::uint64_t threads) {
    struct Bytes {
        std::uint64_t cells, threads;
        // Every thread keeps the costs of the feature it is at; the passes of all are
        // remembered for the next run, up to a bound, once as they grow and once to
        // write.
        std::uint64_t operator()(const distance::Options& o) const {
            const std::uint64_t passes = std::min(kPasses, 200 * cells);
            return cells * (80 + 25 * threads) + (o.preview ? 0 : 2 * passes);
        }
        // The model is read whole; our own exr files pack a height into a byte at best.
        std::uint64_t operator()(const dem::Options& o) const {
            return 24 * std::min(kMostModel,
                                 samples_of_dem(o.source).value_or(o.source.size)) +
                   16 * cells;
        }
        // The land with its own details, what is quilted and put together; targets with
        // theirs, in every orientation.
        std::uint64_t operator()(const detail::Options& o) const {
            std::uint64_t targets = 0;
            for (const detail::Target& target : o.targets)
                targets +=
                    std::min(kMostModel,
                             samples_of_dem(target.source).value_or(target.source.size));
            const std::uint64_t copies = static_cast<std::uint64_t>(o.orientations);
            return (40 + (o.mappings.empty() && !o.paint ? 0 : 8)) * cells +
                   (24 + 16 * copies) * targets;
        }
        // All scales of the land, footprints as large as it, and what lies under those
        // that others are seen through; real land's noise is made like land.
        std::uint64_t operator()(const sketch::Options& o) const {
            constexpr std::uint64_t kDrawings = 64 * kMega;
            const auto seen_through = static_cast<std::uint64_t>(
                std::ranges::count_if(o.features, [](const sketch::Feature& feature) {
                    return feature.view && !feature.view->through.empty();
                }));
            std::uint64_t noise = 0;
            if (o.noise != sketch::NoiseKind::kWavelet && o.noise_from) {
                texture::Options land;
                land.exemplars.push_back({*o.noise_from, {}, {}});
                noise =
                    o.noise == sketch::NoiseKind::kTexture
                        ? (*this)(land)
                        : 40 * cells + 8 * static_cast<std::uint64_t>(o.levels) * cells;
            }
            return (120 + 4 * static_cast<std::uint64_t>(o.levels) +
                    (seen_through > 0 ? 32 : 0)) *
                       cells +
                   noise + kDrawings;
        }
        // A population of heights and their statistics, all samples of the library at
        // all levels, and what texture knows of them.
        std::uint64_t operator()(const genetic::Options& o) const {
            texture::Options land;
            for (const genetic::TypeOptions& type : o.library.types)
                for (const genetic::Example& example : type.examples)
                    land.exemplars.push_back({example.source, {}, {}});
            const auto types = static_cast<std::uint64_t>(o.library.types.size());
            return 60 * exemplar_cells(land) + (*this)(land) +
                   (60 + 8 * types +
                    20 * static_cast<std::uint64_t>(o.evolution.population)) *
                       cells;
        }
        // Measured 117 a cell of the exemplars while they are prepared, and 56 a cell of
        // the land after that; 191 with recordings of all passes, for and of a run.
        std::uint64_t operator()(const texture::Options& o) const {
            const std::uint64_t exemplars = exemplar_cells(o);
            return std::max(130 * exemplars,
                            43 * exemplars + (o.coherent ? 215 : 80) * cells) +
                   4 * o.types.size() * cells;
        }
        // Reading an image comes before solving for all of them.
        std::uint64_t operator()(const pareidolia::Options& o) const {
            // Rows of light follow the mesh with up to four samples a cell.
            const bool rows = o.solver == pareidolia::Solver::kConstrained;
            std::uint64_t needed = (rows ? 180 + 200 * o.images.size() : 160) * cells;
            for (const pareidolia::ImageOptions& image : o.images)
                needed = std::max(needed, of_image(image, cells));
            return needed;
        }
    };
    return kProgram + std::visit(Bytes{cells, threads}, options);
}

std::uint64_t of_tile(std::span<const StageOptions* const> stages, const Extent& land,
                      int width, int height, std::uint64_t threads) {
    constexpr std::uint64_t kPicture = 64 * kMega;
    const int around = 2 * reach(stages, land);
    const auto with = [&](int samples, int all) {
        return static_cast<std::uint64_t>(std::min(samples + around, all));
    };
    const std::uint64_t cells = with(width, land.columns) * with(height, land.rows);
    std::uint64_t most = 0;
    for (const StageOptions* stage : stages)
        most = std::max(most, of_stage(*stage, cells, threads));
    return most + 16 * cells + kPicture;
}

std::uint64_t of_export(std::uint64_t cells) { return kProgram + 60 * cells; }
// Measured 138 a sample of the solid: its mesh, and the file in memory.
std::uint64_t of_solid(std::uint64_t cells, int samples) {
    const auto side = static_cast<std::uint64_t>(std::max(samples, 2));
    return kProgram + 60 * cells + 160 * std::min(cells, side * side);
}
std::uint64_t of_heights(std::uint64_t cells, int samples, bool as_text) {
    const auto side = static_cast<std::uint64_t>(samples);
    return kProgram + 24 * cells + (as_text ? 90 : 30) * std::min(cells, side * side);
}
// Its vertices and triangles once in arrays and twice in the file, and both textures.
std::uint64_t of_gltf(std::uint64_t cells, int samples) {
    const auto side = static_cast<std::uint64_t>(std::max(samples, 2));
    return kProgram + 40 * cells + 18 * ground_pixels(cells) +
           250 * std::min(cells, side * side);
}
// Land and base are cast, several suns at once.
std::uint64_t of_check(std::uint64_t cells) { return kProgram + 130 * cells; }

std::uint64_t of_emit(std::uint64_t cells) {
    return kProgram + 18 * ground_pixels(cells) + 15 * cells;
}

std::uint64_t of_trace(std::uint64_t cells, std::uint64_t pixels) {
    return kProgram + kPovray + 4 * ground_pixels(cells) + 24 * cells + 28 * pixels;
}

// Measured 396 MiB of 1024 x 1024 cells and 1920 x 1080 pixels, without the maps.
std::uint64_t of_passes(std::uint64_t cells, std::uint64_t pixels) {
    return kProgram + 5 * ground_pixels(cells) + 110 * cells + 100 * pixels;
}

std::uint64_t of_delivery(std::uint64_t pixels) { return kProgram + 48 * pixels; }

std::uint64_t available() {
    return std::min({machine_available(), group_available(), address_space_limit()});
}

void refuse_unless_it_fits(std::uint64_t needed, std::uint64_t available) {
    if (needed <= available) return;
    throw failure(
        "this needs about {} of memory and {} is available; lower terrain.samples or "
        "the cameras' size",
        bytes_text(needed), bytes_text(available));
}

}  // namespace memory

std::string bytes_text(std::uint64_t bytes) {
    const double mega = static_cast<double>(bytes) / 1e6;
    return mega < 1000.0 ? fmt::format("{:.0f} MB", mega)
                         : fmt::format("{:.1f} GB", mega / 1000.0);
}

}  // namespace cydonia
