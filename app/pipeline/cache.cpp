#include "app/pipeline/cache.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <vector>

#include "field/archive.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

constexpr std::string_view kKind = "cydonia terrain 5\n";
constexpr const char* kExtension = ".terrain";
constexpr std::uint32_t kMaxItems = 4096;

void write(const Terrain& terrain, ArchiveWriter& out) {
    const auto count = [&out](const auto& items) {
        out.value(static_cast<std::uint32_t>(items.size()));
    };
    out.value(terrain.spacing);
    out.field(terrain.heights);
    count(terrain.masks);
    for (const auto& [name, mask] : terrain.masks) {
        out.text(name);
        out.field(mask);
    }
    count(terrain.shadows);
    for (const ShadowImage& image : terrain.shadows) {
        out.text(image.name);
        out.field(image.target);
        out.value(image.sun);
        out.value(image.min_iou);
        out.field(image.window);
        out.field(image.relaxed);
    }
    out.field(terrain.water);
    count(terrain.figures);
    for (const auto& [name, value] : terrain.figures) {
        out.text(name);
        out.value(value);
    }
    count(terrain.pictures);
    for (const auto& [name, picture] : terrain.pictures) {
        out.text(name);
        out.field(picture);
    }
}

Terrain read(ArchiveReader& in) {
    const auto count = [&in] { return in.at_most<std::uint32_t>(kMaxItems); };
    Terrain terrain;
    terrain.spacing = in.value<double>();
    terrain.heights = in.field<float>();
    for (std::uint32_t left = count(); left > 0; --left) {
        std::string name = in.text();
        terrain.masks.emplace(std::move(name), in.field<float>());
    }
    for (std::uint32_t left = count(); left > 0; --left) {
        ShadowImage image;
        image.name = in.text();
        image.target = in.field<std::uint8_t>();
        image.sun = in.value<Sun>();
        image.min_iou = in.value<double>();
        image.window = in.field<std::uint8_t>();
        image.relaxed = in.field<std::uint8_t>();
        terrain.shadows.push_back(std::move(image));
    }
    terrain.water = in.field<float>();
    for (std::uint32_t left = count(); left > 0; --left) {
        std::string name = in.text();
        terrain.figures.emplace(std::move(name), in.value<double>());
    }
    for (std::uint32_t left = count(); left > 0; --left) {
        std::string name = in.text();
        terrain.pictures.emplace(std::move(name), in.field<Rgb8>());
    }
    return terrain;
}

}  // namespace

fs::path cached_terrain(const fs::path& folder, Key key) {
    return folder / (hex(key) + kExtension);
}

void store_terrain(const fs::path& file, const Terrain& terrain) {
    write_archive(file, kKind,
                  archive_of([&](ArchiveWriter& out) { write(terrain, out); }));
}

std::optional<Terrain> load_terrain(const fs::path& file) {
    const std::optional<std::string> body = read_archive(file, kKind);
    if (!body) return std::nullopt;
    auto terrain = read_back(*body, [](ArchiveReader& in) { return read(in); });
    std::error_code none;
    if (terrain) fs::last_write_time(file, fs::file_time_type::clock::now(), none);
    return terrain;
}

void prune_terrains(const fs::path& folder, std::uint64_t max_bytes,
                    std::span<const fs::path> kept) {
    struct Cached {
        fs::file_time_type used;
        std::uintmax_t size;
        fs::path path;
    };
    std::vector<Cached> cached;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        if (entry.path().extension() != kExtension) continue;
        cached.push_back(
            {entry.last_write_time(none), entry.file_size(none), entry.path()});
    }
    std::ranges::sort(cached, std::greater{}, &Cached::used);
    std::uint64_t total = 0;
    for (const Cached& c : cached) {
        const bool stays =
            &c == &cached.front() || std::ranges::find(kept, c.path) != kept.end();
        if (!stays && total + c.size > max_bytes)
            fs::remove(c.path, none);
        else
            total += c.size;
    }
}

}  // namespace cydonia
