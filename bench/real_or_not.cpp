// Blind pairs of real and synthetic land (Gain, Merry and Marais 2015, section 6): see
// bench/real-or-not.sh.
//
//     build/bench/bench/real_or_not FOLDER PAIRS EXEMPLAR...
//     build/bench/bench/real_or_not --score FOLDER
//
// Both lands of a pair are of one exemplar: a piece of it, and as much land made of it,
// equally turned, lit and seen. Pieces of an exemplar are taken where they share least.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "bench/blind_key.h"
#include "bench/blind_page.h"
#include "bench/land_figures.h"
#include "bench/measure.h"
#include "field/dem.h"
#include "field/files.h"
#include "field/image.h"
#include "field/random.h"
#include "synth/texture/database/database.h"
#include "synth/texture/database/orientation.h"
#include "synth/texture/synthesis/synthesis.h"

using namespace cydonia;
namespace fs = std::filesystem;

namespace {

constexpr int kLongest = 512;           // cells a side
constexpr double kShare = 2.0 / 3.0;    // of the exemplar's shorter side, at most
constexpr int kTries = 64;              // places, of which the least seen is taken
constexpr double kRelief = 1.0 / 25.0;  // of the width: gentler land is exaggerated

struct Corner {
    int x, y;
};

struct Exemplar {
    Terrain model;
    std::shared_ptr<const texture::Database> database;
    int side;
    double exaggeration;
    std::vector<Corner> shown;  // pieces of it
};

// What nine in ten cells lie within.
double typical_relief(const Field<float>& land) {
    std::vector<float> heights(land.begin(), land.end());
    const auto at = [&](double share) {
        const auto place =
            heights.begin() +
            static_cast<std::ptrdiff_t>(share * static_cast<double>(heights.size() - 1));
        std::ranges::nth_element(heights, place);
        return static_cast<double>(*place);
    };
    return at(0.95) - at(0.05);
}

Exemplar exemplar_of(const fs::path& path, const fs::path& cache) {
    texture::Options options;
    options.exemplars.push_back({open_source(path), {}, {}});
    SilentProgress silent;
    Exemplar exemplar{read_dem(options.exemplars[0].source),
                      texture::database_of(options, cache, silent),
                      0,
                      1.0,
                      {}};
    const Field<float>& heights = exemplar.model.heights;
    exemplar.side = std::min(
        kLongest, static_cast<int>(kShare * std::min(heights.width(), heights.height())));
    const double wanted = kRelief * exemplar.side * exemplar.model.spacing;
    exemplar.exaggeration =
        std::clamp(wanted / std::max(typical_relief(heights), 1.0), 1.0, 5.0);
    return exemplar;
}

// Of hashed places the one furthest from those shown before.
Corner unseen(Exemplar& exemplar, std::uint64_t seed) {
    const auto at = [&](int i, const char* axis, int cells) {
        return static_cast<int>(unit(hash_of({seed, key(axis), std::uint64_t(i)})) *
                                (cells - exemplar.side + 1));
    };
    Corner best{};
    double furthest = -1.0;
    for (int i = 0; i < kTries; ++i) {
        const Corner corner{at(i, "x", exemplar.model.heights.width()),
                            at(i, "y", exemplar.model.heights.height())};
        double nearest = HUGE_VAL;
        for (Corner other : exemplar.shown)
            nearest =
                std::min(nearest, std::hypot(corner.x - other.x, corner.y - other.y));
        if (nearest > furthest) furthest = nearest, best = corner;
    }
    exemplar.shown.push_back(best);
    return best;
}

Field<float> turned(const Field<float>& land, int orientation) {
    const int n = land.width();
    Field<float> result(n, n);
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            // About the middle, in half cells.
            const auto s = texture::turned(orientation, {2 * x - n + 1, 2 * y - n + 1});
            result(x, y) = land((s.x + n - 1) / 2, (s.y + n - 1) / 2);
        }
    return result;
}

Field<float> synthetic(const Exemplar& exemplar, std::uint64_t seed) {
    using namespace texture;
    SilentProgress silent;
    const Controls controls{.seed = seed};
    return heights_of(
        *exemplar.database,
        synthesised(*exemplar.database, controls, {},
                    Window{0, 0, 0, exemplar.side, exemplar.side}.grown(kReadOut),
                    nullptr, silent));
}

Terrain shown(const Exemplar& exemplar, const Field<float>& land, int orientation) {
    Field<float> heights = turned(land, orientation);
    for (float& height : heights) height *= static_cast<float>(exemplar.exaggeration);
    return {heights, exemplar.model.spacing, {}, {}, {}};
}

Field<Rgb8> page_of(Exemplar& exemplar, bool real_is_a, std::uint64_t seed) {
    const auto number = [&](const char* what) { return hash_of({seed, key(what)}); };
    const int turn = static_cast<int>(number("turn") % 8);
    const bench::View view{radians(20.0 + 50.0 * unit(number("view"))),
                           number("sun") % 2 == 0};
    const Corner at = unseen(exemplar, number("piece"));
    const Terrain real = shown(
        exemplar, part(exemplar.model.heights, at.x, at.y, exemplar.side, exemplar.side),
        turn);
    const Terrain made = shown(exemplar, synthetic(exemplar, number("land")), turn);
    return real_is_a ? bench::blind_page(real, made, view)
                     : bench::blind_page(made, real, view);
}

void make(const fs::path& folder, int count, const std::vector<fs::path>& paths) {
    const std::uint64_t seed =
        std::uint64_t(std::random_device{}()) << 32 | std::random_device{}();
    const bench::ScratchFolder cache;
    make_folder(folder);
    std::map<fs::path, Exemplar> exemplars;
    std::vector<bench::Pair> pairs;
    std::string blank =
        "# Which of the two is real land? Write A or B after each number.\n";
    for (int i = 0; i < count; ++i) {
        const std::uint64_t pair_seed = hash_of({seed, std::uint64_t(i)});
        const fs::path& path = paths[static_cast<std::size_t>(i) % paths.size()];
        if (!exemplars.contains(path))
            exemplars.emplace(path, exemplar_of(path, cache.path()));
        pairs.push_back(
            {hash_of({pair_seed, key("order")}) % 2 == 0, path.stem().string()});
        const std::string name = fmt::format("{:02}", i + 1);
        write_png(folder / fmt::format("pair-{}.png", name),
                  page_of(exemplars.at(path), pairs.back().real_is_a, pair_seed));
        blank += name + " ?\n";
        write_text(folder / "key", bench::hidden(pairs, seed));
        write_text(folder / "answers.txt", blank);
        fmt::print("pair {} of {}\n", i + 1, count);
        std::fflush(stdout);
    }
}

int score(const fs::path& folder) {
    const std::vector<bench::Pair> pairs = bench::revealed(read_text(folder / "key"));
    const std::string answers =
        bench::answers_of(read_text(folder / "answers.txt"), pairs.size());
    int right = 0, all = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (answers[i] == '?') continue;
        const bool found = (answers[i] == 'A') == pairs[i].real_is_a;
        right += found, ++all;
        fmt::print("{:02} {:20} {}\n", i + 1, pairs[i].landform,
                   found ? "right" : "took the made one for real");
    }
    if (all == 0) throw bad_request("answers.txt: no pair is answered");
    fmt::print(
        "{} of {} right, {:.0f} % ({} not answered); as many or more by guessing: p = "
        "{:.3f}\n",
        right, all, 100.0 * right / all, pairs.size() - static_cast<std::size_t>(all),
        bench::chance_of_at_least(right, all));
    return 10 * right <= 6 * all ? 0 : 3;
}

}  // namespace

int main(int argc, char** argv) try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() == 2 && words[0] == "--score") return score(words[1]);
    if (words.size() < 3 || std::atoi(argv[2]) < 1 || std::atoi(argv[2]) > 1000) {
        fmt::print(stderr,
                   "real_or_not FOLDER PAIRS EXEMPLAR...\n"
                   "real_or_not --score FOLDER\n");
        return 2;
    }
    make(words[0], std::atoi(argv[2]), {words.begin() + 2, words.end()});
    return 0;
} catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(error.code());
}
