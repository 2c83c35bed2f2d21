#include "app/pipeline/memory.h"

#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

#include "field/error.h"

namespace cydonia {
namespace {

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kMega = 1'000'000;
constexpr std::uint64_t kProgram = 175 * kMega;  // code, libraries, thread pools
constexpr std::uint64_t kPovray = 40 * kMega;    // the same of POV-Ray

// The first number of a file such as the kernel's accounts; unlimited when there is none
// ("max").
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

// As a container sees its own group, versions 2 and 1.
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

}  // namespace

namespace memory {

std::uint64_t of_stage(const StageOptions& options, std::uint64_t cells,
                       std::uint64_t threads) {
    return kProgram + peak_memory(options, cells, threads);
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
        "this needs about {} of memory and {} are available; lower terrain.samples or "
        "the "
        "cameras' size",
        bytes_text(needed), bytes_text(available));
}

}  // namespace memory

std::string bytes_text(std::uint64_t bytes) {
    const double mega = static_cast<double>(bytes) / 1e6;
    return mega < 1000.0 ? fmt::format("{:.0f} MB", mega)
                         : fmt::format("{:.1f} GB", mega / 1000.0);
}

}  // namespace cydonia
