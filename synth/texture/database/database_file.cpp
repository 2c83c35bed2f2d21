#include "synth/texture/database/database_file.h"

#include <algorithm>
#include <string_view>
#include <system_error>

#include "field/error.h"
#include "synth/texture/database/database_layout.h"

namespace cydonia::texture {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPrefix = "exemplars-";
constexpr std::string_view kExtension = ".db";

class Key {
  public:
    template <class T>
    requires std::is_arithmetic_v<T>
    void add(T value) { add(&value, sizeof value); }
    void add(std::string_view text) {
        add(text.size());
        add(text.data(), text.size());
    }
    void add(const Source& source) {
        add(source.hash);
        add(source.size);
    }
    std::uint64_t result() const { return state_; }

  private:
    void add(const void* bytes, std::size_t count) {
        state_ = XXH3_64bits_withSeed(bytes, count, state_);
    }
    std::uint64_t state_ = 0;
};

}  // namespace

std::uint64_t database_key(const Options& options) {
    Key key;
    key.add(std::string_view(kMagic));
    key.add(options.exemplars.size());
    for (const Exemplar& exemplar : options.exemplars) {
        key.add(exemplar.source);
        key.add(exemplar.source.name());
        key.add(exemplar.types.has_value());
        if (exemplar.types) key.add(*exemplar.types);
        key.add(exemplar.type);
        for (const double side : exemplar.window) key.add(side);
        key.add(exemplar.scale);
        key.add(exemplar.vertical_scale);
        key.add(exemplar.raise);
    }
    key.add(options.spacing);
    key.add(options.scale);
    key.add(options.vertical_scale);
    key.add(options.levels);
    key.add(options.orientations);
    key.add(options.types.size());
    for (const Type& type : options.types) {
        key.add(type.name);
        for (std::uint8_t part : type.colour) key.add(part);
    }
    key.add(options.automatic_types);
    return key.result();
}

fs::path database_file(const fs::path& folder, std::uint64_t key) {
    return folder / fmt::format("{}{:016x}{}", kPrefix, key, kExtension);
}

void prune_databases(const fs::path& folder, std::uint64_t most) {
    struct CacheFile {
        fs::file_time_type used;
        std::uintmax_t size;
        fs::path path;
    };
    std::vector<CacheFile> kept;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        const std::string name = entry.path().filename().string();
        const bool half_written = name.starts_with(fmt::format(".{}", kPrefix));
        if (!name.starts_with(kPrefix) && !half_written) continue;
        if (!name.ends_with(kExtension)) continue;
        kept.push_back(
            {entry.last_write_time(none), entry.file_size(none), entry.path()});
    }
    std::ranges::sort(kept, std::greater{}, &CacheFile::used);
    std::uint64_t total = 0;
    for (const CacheFile& file : kept) {
        total += file.size;
        if (total > most && &file != &kept.front()) fs::remove(file.path, none);
    }
}

}  // namespace cydonia::texture
