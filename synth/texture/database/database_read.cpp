#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <system_error>

#include "field/archive.h"
#include "field/parallel.h"
#include "synth/texture/database/database_file.h"
#include "synth/texture/database/database_layout.h"
#include "synth/texture/database/pyramid.h"

namespace cydonia::texture {
namespace {

void expect(bool sound) { ArchiveReader::expect(sound); }

// The bytes of a mapped file, valid as long as this lives; none when the file cannot be
// mapped.
class Mapping {
  public:
    explicit Mapping(const std::filesystem::path& path) {
        const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
        if (file < 0) return;
        struct stat status {};
        if (fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0) {
            const auto size = static_cast<std::size_t>(status.st_size);
            void* start = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
            if (start != MAP_FAILED) bytes_ = {static_cast<const char*>(start), size};
        }
        close(file);
    }
    ~Mapping() {
        if (!bytes_.empty()) munmap(const_cast<char*>(bytes_.data()), bytes_.size());
    }
    Mapping(const Mapping&) = delete;
    Mapping& operator=(const Mapping&) = delete;

    std::span<const char> bytes() const { return bytes_; }

  private:
    std::span<const char> bytes_;
};

template <class T>
std::span<const T> aligned_values(ArchiveReader& in, std::uint64_t count) {
    in.align(kAligned);
    return in.values<T>(count);
}

std::vector<std::uint64_t> hashes_of(std::span<const char> body) {
    std::vector<std::uint64_t> hashes(body.size() / kPiece + 1);
    parallel_for(static_cast<int>(hashes.size()), [&](int i) {
        const std::size_t first = std::size_t(i) * kPiece;
        const auto piece = body.subspan(first, std::min(kPiece, body.size() - first));
        hashes[std::size_t(i)] = XXH3_64bits(piece.data(), piece.size());
    });
    return hashes;
}

bool is_place(const Level& level, std::uint64_t exemplar, std::uint64_t x,
              std::uint64_t y) {
    if (exemplar >= level.sheets.size()) return false;
    const Sheet& sheet = level.sheets[exemplar];
    return x < std::uint64_t(sheet.width) && y < std::uint64_t(sheet.height);
}

// Checks that all matches, types and seeds of a level stay within its arrays.
void expect_sound(const Level& level) {
    std::atomic<bool> sound = true;
    constexpr int kBlock = 1 << 16;
    const std::size_t cells = level.heights.size();
    parallel_for(static_cast<int>(cells / kBlock + 1), [&](int block) {
        bool fits = true;
        const std::size_t first = std::size_t(block) * kBlock;
        for (std::size_t i = first; i < std::min(first + kBlock, cells); ++i) {
            const Match& match = level.matches[i];
            fits &= is_place(level, match.exemplar, match.x, match.y) &&
                    match.orientation < 8 && std::isfinite(level.heights[i]) &&
                    (level.types[i] < level.seeds.size() || level.types[i] >= kNoType);
        }
        if (!fits) sound = false;
    });
    for (std::int8_t sign : level.last_sign) expect(sign == 1 || sign == -1);
    for (const auto& seeds : level.seeds)
        for (std::uint64_t seed : seeds)
            expect(is_place(level, seed >> 48, seed & 0xffffff, seed >> 24 & 0xffffff));
    expect(sound);
}

class MappedDatabase final : public Database {
  public:
    MappedDatabase(const std::filesystem::path& file, std::uint64_t key)
        : mapping_(file) {
        const std::span<const char> bytes = mapping_.bytes();
        Head head;
        expect(bytes.size() >= sizeof head);
        std::memcpy(&head, bytes.data(), sizeof head);
        const auto body = bytes.subspan(sizeof head);
        expect(std::memcmp(head.magic, kMagic, sizeof kMagic) == 0);
        expect(head.key == key && head.size == body.size());
        expect(head.checksum == checksum_of(head, hashes_of(body)));
        read(head, ArchiveReader({body.data(), body.size()}));
    }

  private:
    void read(const Head& head, ArchiveReader in) {
        read_figures(head);
        std::vector<Size> sizes = read_exemplars(head.exemplars, in);
        for (std::uint32_t i = 0; i < head.levels; ++i) {
            sheets_.push_back(sheets_of(sizes));
            levels.push_back(level_of(sheets_.back(), head.types, in));
            expect_sound(levels.back());
            std::ranges::transform(sizes, sizes.begin(), coarser_size);
        }
        expect(in.at_end());
    }

    void read_figures(const Head& head) {
        spacing = head.spacing;
        unit = head.unit;
        lowest = head.lowest;
        highest = head.highest;
        expect(std::isfinite(spacing) && spacing > 0.0);
        expect(std::isfinite(unit) && unit > 0.0);
        expect(std::isfinite(lowest) && std::isfinite(highest));
        expect(head.exemplars >= 1 && head.exemplars <= kMostExemplars);
        expect(head.levels >= 1 && head.levels <= kMostLevels);
        expect(head.types <= kMostTypes);
    }

    std::vector<Size> read_exemplars(std::uint32_t count, ArchiveReader& in) {
        std::vector<Size> sizes;
        for (; count > 0; --count) {
            const auto width = in.value<std::uint32_t>();
            const auto height = in.value<std::uint32_t>();
            expect(width >= 1 && width <= kLongestSide);
            expect(height >= 1 && height <= kLongestSide);
            sizes.push_back({static_cast<int>(width), static_cast<int>(height)});
            names.push_back(in.text());
            expect(names.back().size() <= kLongestName);
        }
        return sizes;
    }

    static Level level_of(const std::vector<Sheet>& sheets, std::uint32_t types,
                          ArchiveReader& in) {
        Level level;
        level.sheets = sheets;
        level.last_sign = in.value<std::array<std::int8_t, 8>>();
        std::vector<std::uint64_t> counts(types);
        for (std::uint64_t& count : counts) count = in.at_most<std::uint64_t>(kSeeds);
        const std::size_t cells = cells_of(sheets);
        level.heights = aligned_values<float>(in, cells);
        level.appearance = aligned_values<Appearance>(in, cells);
        level.matches = aligned_values<Match>(in, cells);
        level.types = aligned_values<std::uint8_t>(in, cells);
        for (std::uint64_t count : counts)
            level.seeds.push_back(aligned_values<std::uint64_t>(in, count));
        return level;
    }

    static constexpr std::uint64_t kLongestName = 4096;

    Mapping mapping_;
    std::vector<std::vector<Sheet>> sheets_;
};

}  // namespace

std::shared_ptr<const Database> mapped_database(const std::filesystem::path& file,
                                                std::uint64_t key) {
    try {
        auto database = std::make_shared<MappedDatabase>(file, key);
        std::error_code ignored;  // marks the file as used now
        std::filesystem::last_write_time(
            file, std::filesystem::file_time_type::clock::now(), ignored);
        return database;
    } catch (const DamagedArchive&) {
        return nullptr;
    }
}

}  // namespace cydonia::texture
