#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>

#include "field/archive.h"
#include "field/error.h"
#include "field/files.h"
#include "synth/texture/database/database_file.h"
#include "synth/texture/database/database_layout.h"

namespace cydonia::texture {
namespace {

// The body of a file, hashed piece by piece as it goes out.
class Body {
  public:
    Body(std::ofstream& out, Progress& progress) : out_(out), progress_(progress) {
        piece_.reserve(kPiece);
    }

    void write(std::string_view all) {
        while (!all.empty()) {
            const auto part = all.substr(0, kPiece - piece_.size());
            piece_.insert(piece_.end(), part.begin(), part.end());
            all.remove_prefix(part.size());
            if (piece_.size() == kPiece) flush();
        }
    }
    void flush() {
        hashes_.push_back(XXH3_64bits(piece_.data(), piece_.size()));
        out_.write(piece_.data(), std::ssize(piece_));
        piece_.clear();
        progress_.report(1.0);
    }

    const std::vector<std::uint64_t>& hashes() const { return hashes_; }

  private:
    std::ofstream& out_;
    Progress& progress_;
    std::vector<char> piece_;
    std::vector<std::uint64_t> hashes_;
};

Head head_of(const Database& database, std::uint64_t key, std::uint64_t size,
             const Body& body) {
    Head head{};
    std::memcpy(head.magic, kMagic, sizeof head.magic);
    head.key = key;
    head.size = size;
    head.spacing = database.spacing;
    head.unit = database.unit;
    head.lowest = database.lowest;
    head.highest = database.highest;
    head.exemplars = static_cast<std::uint32_t>(database.names.size());
    head.levels = static_cast<std::uint32_t>(database.levels.size());
    head.types = static_cast<std::uint32_t>(database.levels.front().seeds.size());
    head.checksum = checksum_of(head, body.hashes());
    return head;
}

template <class T>
void put_aligned(ArchiveWriter& out, std::span<const T> values) {
    out.align(kAligned);
    out.values(values);
}

void put(ArchiveWriter& out, const Level& level) {
    out.value(level.last_sign);
    for (const auto& seeds : level.seeds)
        out.value(static_cast<std::uint64_t>(seeds.size()));
    put_aligned(out, level.heights);
    put_aligned(out, level.appearance);
    put_aligned(out, level.matches);
    put_aligned(out, level.types);
    for (const auto& seeds : level.seeds) put_aligned(out, seeds);
}

void put(ArchiveWriter& out, const Database& database) {
    for (std::size_t e = 0; e < database.names.size(); ++e) {
        const Sheet& sheet = database.levels.front().sheets[e];
        out.value(static_cast<std::uint32_t>(sheet.width));
        out.value(static_cast<std::uint32_t>(sheet.height));
        out.text(database.names[e]);
    }
    for (const Level& level : database.levels) put(out, level);
}

}  // namespace

void write_database(const std::filesystem::path& file, std::uint64_t key,
                    const Database& database, Progress& progress) {
    write_atomically(file, [&](const std::filesystem::path& temporary) {
        errno = 0;
        std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
        Head head{};
        out.write(reinterpret_cast<const char*>(&head), sizeof head);
        Body body(out, progress);
        ArchiveWriter archive([&](std::string_view part) { body.write(part); });
        put(archive, database);
        body.flush();
        head = head_of(database, key, archive.size(), body);
        out.seekp(0);
        out.write(reinterpret_cast<const char*>(&head), sizeof head);
        out.close();
        if (!out)
            throw failure("cannot write {}: {}", file.string(),
                          errno == 0 ? "unknown reason" : std::strerror(errno));
    });
}

}  // namespace cydonia::texture
