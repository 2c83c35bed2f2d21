#pragma once

// Small stages of distance terrain for the tests of their parts.

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "field/image.h"
#include "synth/distance/distance.h"

namespace cydonia::distance {

inline Terrain flat(int width, int height, double extent = 5120.0) {
    Terrain terrain;
    terrain.heights = Field<float>(width, height);
    terrain.spacing = extent / width;
    return terrain;
}

inline Terrain land(const Options& options, const Terrain& ground,
                    std::uint64_t seed = 1) {
    SilentProgress silent;
    Context context;
    context.seed = seed;
    context.progress = &silent;
    return run(options, ground, context);
}

inline Options peaks(int count) {
    Peaks where;
    where.placement.count = count;
    Options options;
    options.groups.resize(1);
    options.groups[0].name = "peaks";
    options.groups[0].where = where;
    return options;
}

inline int& count_of(Options& options) {
    return std::get<Peaks>(options.groups[0].where).placement.count;
}

// The same options with one profile for all features.
inline Options shaped(Options options, std::vector<std::array<double, 2>> points,
                      std::optional<Length> reach = {}) {
    Profile profile;
    profile.name = "shape";
    profile.curve.points = std::move(points);
    profile.reach = reach;
    options.profiles = {profile};
    options.groups[0].profile = {"shape"};
    return options;
}

inline void set_range(Options& options, double low, double high) {
    options.groups[0].cost.kind = CostRule::Kind::kRandom;
    options.groups[0].cost.range = {{metres(low), metres(high)}};
}

// The example of Rusnell 2009, chapter 3.
inline Options running_example() {
    Options options = peaks(25);
    options.groups[0].ridges.count = 38;
    std::vector<std::array<double, 2>> points;
    for (int i = 0; i <= 20; ++i) {
        const double x = i / 20.0;
        points.push_back({130.0 * x, (1.0 - x) * (1.0 - x)});
    }
    return shaped(options, points);
}

// One peak, 200 m above a sea level cost of 300 m, on weights without chance.
inline Options one_peak() {
    Options options = peaks(1);
    set_range(options, 100.0, 100.0);
    options.sea_level_scale = 3.0;
    options.edge_weight_deviation = 0.0;
    options.sea_level_threshold = metres(0.1);
    return options;
}

class Picture {
  public:
    explicit Picture(const Field<Rgb8>& pixels) : path_(new_path()) {
        write_png(path_, pixels);
    }
    ~Picture() { std::filesystem::remove(path_); }
    Source source() const { return open_source(path_); }

  private:
    static std::filesystem::path new_path() {
        static int count = 0;
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        return std::filesystem::temp_directory_path() /
               ("cydonia-" + std::string(test->test_suite_name()) + "-" + test->name() +
                "-" + std::to_string(++count) + ".png");
    }
    std::filesystem::path path_;
};

inline constexpr Rgb8 kWhite{255, 255, 255}, kBlack{0, 0, 0};

}  // namespace cydonia::distance
