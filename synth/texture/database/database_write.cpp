#include <cerrno>
#include <fstream>

#include "field/error.h"
#include "field/files.h"
#include "synth/texture/database/database_file.h"
#include "synth/texture/database/database_layout.h"

namespace cydonia::texture {
namespace {

// The body of a file, hashed as it goes out.
class Body {
  public:
    Body(std::ofstream& out, Progress& progress) : out_(out), progress_(progress) {
        piece_.reserve(kPiece);
    }

    template <class T>
    void value(const T& v) {
        static_assert(std::has_unique_object_representations_v<T>);
        bytes({reinterpret_cast<const char*>(&v), sizeof v});
    }
    template <class T>
    void array(std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        static constexpr char kZeros[kAligned] = {};
        bytes({kZeros, (kAligned - size_ % kAligned) % kAligned});
        bytes({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
    }
    void bytes(std::span<const char> all) {
        size_ += all.size();
        while (!all.empty()) {
            const auto part = all.first(std::min(all.size(), kPiece - piece_.size()));
            piece_.insert(piece_.end(), part.begin(), part.end());
            all = all.subspan(part.size());
            if (piece_.size() == kPiece) flush();
        }
    }
    void flush() {
        hashes_.push_back(XXH3_64bits(piece_.data(), piece_.size()));
        out_.write(piece_.data(), std::ssize(piece_));
        piece_.clear();
        progress_.report(1.0);
    }

    std::uint64_t size() const { return size_; }
    const std::vector<std::uint64_t>& hashes() const { return hashes_; }

  private:
    std::ofstream& out_;
    Progress& progress_;
    std::vector<char> piece_;
    std::vector<std::uint64_t> hashes_;
    std::uint64_t size_ = 0;
};

Head head_of(const Database& database, std::uint64_t key, const Body& body) {
    Head head{};
    std::memcpy(head.magic, kMagic, sizeof head.magic);
    head.key = key;
    head.size = body.size();
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

void put(Body& body, const Level& level) {
    body.value(level.last_sign);
    for (const auto& seeds : level.seeds)
        body.value(static_cast<std::uint64_t>(seeds.size()));
    body.array(level.heights);
    body.array(level.appearance);
    body.array(level.matches);
    body.array(level.types);
    for (const auto& seeds : level.seeds) body.array(seeds);
}

void put(Body& body, const Database& database) {
    for (std::size_t e = 0; e < database.names.size(); ++e) {
        const Sheet& sheet = database.levels.front().sheets[e];
        body.value(static_cast<std::uint32_t>(sheet.width));
        body.value(static_cast<std::uint32_t>(sheet.height));
        body.value(static_cast<std::uint64_t>(database.names[e].size()));
        body.bytes(database.names[e]);
    }
    for (const Level& level : database.levels) put(body, level);
    body.flush();
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
        put(body, database);
        head = head_of(database, key, body);
        out.seekp(0);
        out.write(reinterpret_cast<const char*>(&head), sizeof head);
        out.close();
        if (!out)
            throw failure("cannot write {}: {}", file.string(),
                          errno == 0 ? "unknown reason" : std::strerror(errno));
    });
}

}  // namespace cydonia::texture
