#include "synth/texture/database/database.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "field/random.h"
#include "synth/texture/database/database_file.h"
#include "synth/texture/database/database_layout.h"
#include "tests/field/small_disk.h"
#include "tests/synth/texture_lands.h"

namespace cydonia::texture {
namespace {

namespace fs = std::filesystem;

bool same(const Level& a, const Level& b) {
    const auto equal = [](const auto& u, const auto& v) {
        return std::ranges::equal(u, v);
    };
    return equal(a.heights, b.heights) && equal(a.appearance, b.appearance) &&
           equal(a.matches, b.matches) && equal(a.types, b.types) &&
           a.last_sign == b.last_sign && std::ranges::equal(a.seeds, b.seeds, equal) &&
           std::ranges::equal(a.sheets, b.sheets, [](const Sheet& u, const Sheet& v) {
               return u.width == v.width && u.height == v.height &&
                      u.stride == v.stride && u.origin == v.origin;
           });
}

bool same(const Database& a, const Database& b) {
    return a.spacing == b.spacing && a.unit == b.unit && a.lowest == b.lowest &&
           a.highest == b.highest && a.names == b.names &&
           std::ranges::equal(a.levels, b.levels,
                              [](const Level& u, const Level& v) { return same(u, v); });
}

class Databases : public testing::Test {
  protected:
    Databases() {
        options_.exemplars = {exemplar_of(folder_, "a.tif", rough(70, 60)),
                              exemplar_of(folder_, "b.tif", rough(50, 64, 2))};
        options_.types = {{"hills", {1, 2, 3}}};
        options_.exemplars[0].type = "hills";
    }
    std::shared_ptr<const Database> database() {
        listener_.steps.clear();
        return database_of(options_, cache_, listener_);
    }
    bool was_made() const { return !listener_.steps.empty(); }
    fs::path file() const { return database_file(cache_, database_key(options_)); }
    std::string bytes() const { return read_text(file()); }
    void expect_rebuilt(const std::string& damaged, const std::string& what) {
        write_text(file(), damaged);
        EXPECT_EQ(mapped_database(file(), database_key(options_)), nullptr) << what;
    }

    const TemporaryFolder folder_;
    const fs::path cache_ = folder_ / "cache";
    Options options_;
    Listener listener_;
};

TEST_F(Databases, SaysWhatItHolds) {
    const auto made = database();
    EXPECT_EQ(made->spacing, 10.0);
    EXPECT_EQ(made->names, (std::vector<std::string>{"a.tif", "b.tif"}));
    EXPECT_EQ(made->cells(), 70u * 60u + 50u * 64u);
    EXPECT_NEAR(made->unit, (made->highest - made->lowest) / 60000.0, 1e-9);
    EXPECT_EQ(made->levels.size(), 3u);  // 8 x 7 and 6 x 8 cells would be the fourth
    const Level& level = made->levels[0];
    const Sheet& sheet = level.sheets[0];
    EXPECT_EQ(level.types[sheet.index(20, 20)], 0);
    EXPECT_EQ(level.types[level.sheets[1].index(20, 20)], kNoType);
    EXPECT_EQ(level.seeds[0].size(), std::size_t(kSeeds));
    // The first mode is the height above the middle, smoothed.
    const double above =
        level.heights[sheet.index(30, 30)] - 0.5 * (double(made->lowest) + made->highest);
    EXPECT_NEAR(level.appearance[sheet.index(30, 30)][0] * made->unit, above, 60.0);
}

TEST_F(Databases, KeptOnesAreTheSame) {
    const auto made = database_of(options_, {}, listener_);
    const auto kept = database();
    EXPECT_TRUE(was_made());
    const auto mapped = database();
    EXPECT_FALSE(was_made());
    EXPECT_TRUE(same(*made, *kept));
    EXPECT_TRUE(same(*made, *mapped));
    EXPECT_TRUE(listener_.warnings.empty());
}

TEST_F(Databases, NothingIsKeptWithoutAFolder) {
    database_of(options_, {}, listener_);
    EXPECT_FALSE(fs::exists(cache_));
}

TEST_F(Databases, FewBytesACell) {
    options_.exemplars = {exemplar_of(folder_, "large.tif", rough(300, 300))};
    database();
    EXPECT_LT(double(fs::file_size(file())), 30.0 * 300 * 300);
}

TEST_F(Databases, EveryInputHasItsOwn) {
    const std::vector<std::function<void(Options&)>> changes{
        [](Options& o) { o.exemplars.pop_back(); },
        [](Options& o) { std::swap(o.exemplars[0], o.exemplars[1]); },
        [](Options& o) { o.exemplars[0].source.hash ^= 1; },
        [](Options& o) { o.exemplars[1].type = "hills"; },
        [](Options& o) {
            o.exemplars[1].types = Source{"/paint.png", 5, 6};
        },
        [](Options& o) { o.spacing = 10.0; },
        [](Options& o) { o.scale = 2.0; },
        [](Options& o) { o.vertical_scale = 2.0; },
        [](Options& o) { o.levels = 5; },
        [](Options& o) { o.orientations = 2; },
        [](Options& o) {
            o.types.push_back({"plain", {4, 5, 6}});
        },
        [](Options& o) { o.types[0].colour[2] = 9; },
        [](Options& o) { o.automatic_types = true; },
    };
    std::vector<std::uint64_t> keys{database_key(options_)};
    for (const auto& change : changes) {
        Options other = options_;
        change(other);
        keys.push_back(database_key(other));
    }
    std::ranges::sort(keys);
    EXPECT_TRUE(std::ranges::adjacent_find(keys) == keys.end());

    Options other = options_;  // what the synthesis alone depends on
    other.jitter = 0.1;
    other.kappa = 3.0;
    other.coherent = true;
    other.exemplars[0].source.path = "/elsewhere/a.tif";
    EXPECT_EQ(database_key(other), database_key(options_));
}

TEST_F(Databases, DamagedOnesAreMadeAgain) {
    const auto made = database();
    const std::string sound = bytes();
    for (int i = 0; i < 400; ++i) {
        const std::size_t at =
            i < 128 ? std::size_t(i) : mix(std::uint64_t(i)) % sound.size();
        std::string damaged = sound;
        damaged[at] = char(damaged[at] ^ 0x10);
        expect_rebuilt(damaged, fmt::format("byte {}", at));
    }
    for (const std::size_t size : {std::size_t{0}, std::size_t{5}, sizeof(Head) - 1,
                                   sizeof(Head), sound.size() / 2, sound.size() - 1})
        expect_rebuilt(sound.substr(0, size), fmt::format("cut to {}", size));
    expect_rebuilt(sound + '\0', "longer");

    EXPECT_TRUE(same(*database(), *made));
    EXPECT_TRUE(was_made());
    EXPECT_TRUE(listener_.warnings.empty());
    EXPECT_EQ(bytes(), sound);
}

TEST_F(Databases, OtherVersionsAndKeysAreNotTaken) {
    database();
    std::string other = bytes();
    *std::find(other.begin(), other.end(), '\0') = '0';
    expect_rebuilt(other, "another version");
    EXPECT_EQ(mapped_database(file(), database_key(options_) + 1), nullptr);
    EXPECT_EQ(mapped_database(cache_, 1), nullptr);  // a folder
    EXPECT_EQ(mapped_database(cache_ / "none.db", 1), nullptr);
}

// With a checksum that fits, as only malice would have it.
std::string sealed(std::string bytes) {
    std::vector<std::uint64_t> pieces;
    const std::string_view body = std::string_view(bytes).substr(sizeof(Head));
    for (std::size_t at = 0; at <= body.size(); at += kPiece) {
        const auto piece = body.substr(at, kPiece);
        pieces.push_back(XXH3_64bits(piece.data(), piece.size()));
    }
    Head head;
    std::memcpy(&head, bytes.data(), sizeof head);
    head.size = body.size();
    head.checksum = checksum_of(head, pieces);
    std::memcpy(bytes.data(), &head, sizeof head);
    return bytes;
}

bool leads_somewhere(const Level& level, std::uint64_t exemplar, std::uint64_t x,
                     std::uint64_t y) {
    return exemplar < level.sheets.size() &&
           x < std::uint64_t(level.sheets[exemplar].width) &&
           y < std::uint64_t(level.sheets[exemplar].height);
}

// All that a synthesis would follow.
void expect_walkable(const Database& database) {
    for (const Level& level : database.levels) {
        for (const Match& m : level.matches) {
            ASSERT_TRUE(leads_somewhere(level, m.exemplar, m.x, m.y));
            ASSERT_LT(m.orientation, 8);
        }
        for (const std::uint8_t type : level.types)
            ASSERT_TRUE(type < level.seeds.size() || type >= kNoType);
        for (const std::int8_t sign : level.last_sign) ASSERT_EQ(std::abs(sign), 1);
        for (const auto& seeds : level.seeds)
            for (const std::uint64_t seed : seeds)
                ASSERT_TRUE(leads_somewhere(level, seed >> 48, seed & 0xffffff,
                                            seed >> 24 & 0xffffff));
    }
}

TEST_F(Databases, MaliceLeadsNowhere) {
    database();
    const std::string sound = bytes();
    ASSERT_EQ(sealed(sound), sound);
    // Sizes and counts stand at the beginning, places everywhere.
    int taken = 0;
    for (std::uint64_t i = 0; i < 600; ++i) {
        std::string crafted = sound;
        for (std::uint64_t k = 0; k < 3; ++k) {
            const std::uint64_t h = hash_of({i, k});
            const std::size_t end = i % 2 ? 400 : crafted.size();
            crafted[std::max<std::size_t>(80, h % end)] = char(h >> 32);
        }
        write_text(file(), sealed(crafted));
        const auto mapped = mapped_database(file(), database_key(options_));
        if (!mapped) continue;
        expect_walkable(*mapped);
        ++taken;
    }
    EXPECT_GT(taken, 0);
    EXPECT_LT(taken, 500);
}

TEST_F(Databases, CutOrLongerWithAChecksumThatFits) {
    database();
    const std::string sound = bytes();
    for (std::size_t left = sizeof(Head); left < sound.size(); left += sound.size() / 29)
        expect_rebuilt(sealed(sound.substr(0, left)), fmt::format("cut to {}", left));
    expect_rebuilt(sealed(sound + std::string(64, '\0')), "longer");
}

TEST_F(Databases, FolderThatCannotBeWritten) {
    write_text(cache_, "a file is in the way");
    EXPECT_EQ(database()->levels.size(), 3u);
    ASSERT_EQ(listener_.warnings.size(), 1u);
    EXPECT_NE(listener_.warnings[0].find("is not kept"), std::string::npos);
}

TEST_F(Databases, FullDisk) {
    const SmallDisk disk(65536);
    EXPECT_EQ(database()->levels.size(), 3u);
    EXPECT_EQ(listener_.warnings.size(), 1u);
    EXPECT_TRUE(fs::is_empty(cache_));
}

TEST_F(Databases, InterruptedOnesLeaveNothing) {
    for (int at = 0;; ++at) {
        listener_.interrupt_at = at;
        try {
            database();
            break;
        } catch (const Interrupted&) {
            EXPECT_TRUE(!fs::exists(cache_) || fs::is_empty(cache_)) << at;
        }
        ASSERT_LT(at, 200);
    }
    EXPECT_TRUE(fs::exists(file()));
}

TEST_F(Databases, UsedLongestAgoGoFirst) {
    fs::create_directories(cache_);
    const auto now = fs::file_time_type::clock::now();
    for (int i = 0; i < 5; ++i) {
        const fs::path one = database_file(cache_, std::uint64_t(i));
        write_text(one, std::string(1000, 'x'));
        fs::last_write_time(one, now - std::chrono::hours(i == 1 ? 0 : 10 * i + 1));
    }
    write_text(cache_ / "other.terrain", std::string(5000, 'x'));
    prune_databases(cache_, 3500);
    for (const int i : {0, 1, 2}) EXPECT_TRUE(fs::exists(database_file(cache_, i))) << i;
    for (const int i : {3, 4}) EXPECT_FALSE(fs::exists(database_file(cache_, i))) << i;
    prune_databases(cache_, 10);
    EXPECT_TRUE(fs::exists(database_file(cache_, 1)));
    EXPECT_FALSE(fs::exists(database_file(cache_, 0)));
    EXPECT_TRUE(fs::exists(cache_ / "other.terrain"));
}

TEST_F(Databases, UsedAgainCountsAsNew) {
    database();
    const auto old = fs::file_time_type::clock::now() - std::chrono::hours(50);
    fs::last_write_time(file(), old);
    database();
    EXPECT_GT(fs::last_write_time(file()), old + std::chrono::hours(49));
}

TEST_F(Databases, TypesWithoutLandAreNamedEachTime) {
    options_.types.push_back({"plain", {4, 5, 6}});
    database();
    database();
    EXPECT_FALSE(was_made());
    ASSERT_EQ(listener_.warnings.size(), 2u);
    for (const std::string& warning : listener_.warnings)
        EXPECT_NE(warning.find("no exemplar has land of the type 'plain'"),
                  std::string::npos);
}

TEST_F(Databases, TypesAreFoundInTheLand) {
    // Calm in the west, rugged in the east.
    Field<float> heights = rough(128, 96);
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 64; ++x) heights(x, y) *= 0.02f;
    options_.exemplars = {exemplar_of(folder_, "a.tif", heights)};
    options_.types = {{"calm", {1, 2, 3}}, {"rugged", {4, 5, 6}}};
    options_.automatic_types = true;
    const auto made = database();
    const Level& level = made->levels[0];
    EXPECT_EQ(level.types[level.sheets[0].index(30, 50)], 0);
    int rugged = 0;
    for (int y = 10; y < 86; ++y)
        for (int x = 74; x < 118; ++x) rugged += level.types[level.sheets[0].index(x, y)];
    EXPECT_GT(rugged, 76 * 44 / 2);
    EXPECT_TRUE(listener_.warnings.empty());
}

TEST_F(Databases, VoidsThatLeaveNoLand) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    const Field<float> heights = heights_of(
        30, 30, [](int x, int y) { return x % 3 + y % 3 == 0 ? kNan : float(x); });
    options_.exemplars.push_back(exemplar_of(folder_, "holes.tif", heights));
    expect_error(ExitCode::kBadRequest, "holes.tif: its voids leave no 5x5 cells of land",
                 [&] { database(); });
}

TEST_F(Databases, HalfVoidIsOfUse) {
    Field<float> heights = rough(80, 80);
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 50; ++x)
            heights(x, y) = std::numeric_limits<float>::quiet_NaN();
    options_.exemplars = {exemplar_of(folder_, "half.tif", heights)};
    const auto made = database();
    const Level& level = made->levels[0];
    EXPECT_EQ(level.types[level.sheets[0].index(51, 40)], kNowhere);
    EXPECT_EQ(level.types[level.sheets[0].index(60, 40)], kNoType);
    ASSERT_EQ(listener_.notes.size(), 1u);
    EXPECT_NE(listener_.notes[0].find("were interpolated"), std::string::npos);
}

}  // namespace
}  // namespace cydonia::texture
