#include "app/pipeline/cache.h"

#include <fmt/core.h>
#include <xxhash.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

#include "field/checked_file.h"
#include "field/source.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

constexpr std::string_view kMagic = "cydonia terrain 4\n";
constexpr std::string_view kExtension = ".terrain";
constexpr std::uint32_t kMaxSide = 1u << 16;
constexpr std::uint32_t kMaxItems = 4096;
constexpr std::uint32_t kMaxName = 4096;

// Values one after another; every read is checked against what is left.
class Writer {
  public:
    template <class T>
    void value(const T& v) {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes(&v, sizeof v);
    }
    void text(const std::string& s) {
        value(static_cast<std::uint32_t>(s.size()));
        bytes(s.data(), s.size());
    }
    template <class T>
    void field(const Field<T>& f) {
        value(static_cast<std::uint32_t>(f.width()));
        value(static_cast<std::uint32_t>(f.height()));
        bytes(f.data(), f.size() * sizeof(T));
    }
    const std::string& all() const { return all_; }

  private:
    void bytes(const void* from, std::size_t count) {
        all_.append(static_cast<const char*>(from), count);
    }
    std::string all_;
};

struct Damaged {};

class Reader {
  public:
    explicit Reader(std::string_view all) : left_(all) {}

    template <class T>
    T value() {
        T v;
        std::memcpy(&v, take(sizeof v), sizeof v);
        return v;
    }
    std::uint32_t at_most(std::uint32_t limit) {
        const auto count = value<std::uint32_t>();
        if (count > limit) throw Damaged{};
        return count;
    }
    std::string text() {
        const std::uint32_t size = at_most(kMaxName);
        return {take(size), size};
    }
    template <class T>
    Field<T> field() {
        const std::uint32_t width = at_most(kMaxSide);
        const std::uint32_t height = at_most(kMaxSide);
        const std::size_t size = std::size_t{width} * height * sizeof(T);
        const char* from = take(size);
        Field<T> f(static_cast<int>(width), static_cast<int>(height));
        if (size > 0) std::memcpy(f.data(), from, size);
        return f;
    }

  private:
    const char* take(std::size_t count) {
        if (count > left_.size()) throw Damaged{};
        const char* from = left_.data();
        left_.remove_prefix(count);
        return from;
    }
    std::string_view left_;
};

std::string packed(const Terrain& terrain) {
    Writer out;
    out.value(terrain.spacing);
    out.field(terrain.heights);
    out.value(static_cast<std::uint32_t>(terrain.masks.size()));
    for (const auto& [name, mask] : terrain.masks) {
        out.text(name);
        out.field(mask);
    }
    out.value(static_cast<std::uint32_t>(terrain.shadows.size()));
    for (const ShadowImage& image : terrain.shadows) {
        out.text(image.name);
        out.field(image.target);
        out.value(image.sun);
        out.value(image.min_iou);
        out.field(image.window);
        out.field(image.relaxed);
    }
    out.field(terrain.water);
    out.value(static_cast<std::uint32_t>(terrain.figures.size()));
    for (const auto& [name, value] : terrain.figures) {
        out.text(name);
        out.value(value);
    }
    out.value(static_cast<std::uint32_t>(terrain.pictures.size()));
    for (const auto& [name, picture] : terrain.pictures) {
        out.text(name);
        out.field(picture);
    }
    return out.all();
}

Terrain unpacked(std::string_view bytes) {
    Reader in(bytes);
    Terrain terrain;
    terrain.spacing = in.value<double>();
    terrain.heights = in.field<float>();
    for (std::uint32_t left = in.at_most(kMaxItems); left > 0; --left) {
        std::string name = in.text();
        terrain.masks.emplace(std::move(name), in.field<float>());
    }
    for (std::uint32_t left = in.at_most(kMaxItems); left > 0; --left) {
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
    for (std::uint32_t left = in.at_most(kMaxItems); left > 0; --left) {
        std::string name = in.text();
        terrain.figures.emplace(std::move(name), in.value<double>());
    }
    for (std::uint32_t left = in.at_most(kMaxItems); left > 0; --left) {
        std::string name = in.text();
        terrain.pictures.emplace(std::move(name), in.field<Rgb8>());
    }
    return terrain;
}

}  // namespace

std::uint64_t hash_text(std::string_view text) {
    return XXH3_64bits(text.data(), text.size());
}

std::uint64_t hash_of_file(const fs::path& file) {
    std::error_code none;
    return fs::exists(file, none) ? open_source(file).hash : 0;
}

fs::path cached_terrain(const fs::path& folder, std::uint64_t key) {
    return folder / fmt::format("{:016x}{}", key, kExtension);
}

void store_terrain(const fs::path& file, const Terrain& terrain) {
    write_checked(file, kMagic, packed(terrain));
}

std::optional<Terrain> load_terrain(const fs::path& file) {
    const std::optional<std::string> body = read_checked(file, kMagic);
    if (!body) return std::nullopt;
    try {
        Terrain terrain = unpacked(*body);
        std::error_code none;
        fs::last_write_time(file, fs::file_time_type::clock::now(), none);
        return terrain;
    } catch (const Damaged&) {
        return std::nullopt;
    }
}

void prune_terrains(const fs::path& folder, std::uint64_t max_bytes) {
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
        total += c.size;
        if (total > max_bytes && &c != &cached.front()) fs::remove(c.path, none);
    }
}

}  // namespace cydonia
