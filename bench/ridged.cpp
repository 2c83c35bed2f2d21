// Rusnell 2009, section 4.5: the ridged multifractal against distance-based scenes, as
// they are and with detail on their profiles, all of the same relief. The thesis says
// that the ridged multifractal has more detail of high frequency, that profiles could
// carry such detail too, and that it is our ridges that extend. Two measures, means over
// five seeds:
//   fine    share of the slopes' energy in waves shorter than 80 m, 1/64 of the width
//   crests  mean length of the ten longest crest lines, as a share of the width, of the
//           land smoothed by 40 m; crest lines as C. Steger, "An unbiased detector of
//           curvilinear structures" (1998), finds them
// With a path also hillshades beside each other: left the ridged multifractal, right the
// last scene with detail.
//
//     build/bench/bench/ridged [PICTURE.jpg] SCENE.toml...

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "config/reader/scene.h"
#include "field/error.h"
#include "field/files.h"
#include "field/image.h"
#include "field/noise.h"

using namespace cydonia;

namespace {

constexpr int kSide = 512;
constexpr double kSpacing = 10.0;
constexpr double kRelief = 500.0;
constexpr double kFine = 80.0;    // metres
constexpr double kSmooth = 40.0;  //
constexpr double kDetail = 0.7;
constexpr int kSeeds = 5;

Field<float> with_relief(Field<float> land) {
    const auto [low, high] = std::ranges::minmax(land);
    const auto scale = static_cast<float>(kRelief / (high - low));
    for (float& height : land) height = (height - low) * scale;
    return land;
}

Field<float> ridged_multifractal(std::uint64_t seed) {
    const NoiseOptions options{
        .kind = NoiseOptions::Kind::kRidged, .h = 1.0, .octaves = 7, .grid = 4.0};
    return with_relief(noise_field(options, kSide, kSide, 1.0, seed));
}

// The scene's first stage, its profiles with so much detail.
Field<float> distance_based(const std::string& scene, double detail, std::uint64_t seed) {
    const auto spec =
        config::Scene::load(scene, {fmt::format("terrain.samples={}", kSide)}).at(0);
    auto options = std::get<distance::Options>(spec.stages.at(0).options);
    for (distance::Profile& profile : options.profiles) profile.detail = detail;
    SilentProgress silent;
    Context context;
    context.seed = seed;
    context.progress = &silent;
    const Terrain flat{Field<float>(kSide, kSide), kSpacing, {}, {}, {}};
    return with_relief(distance::run(options, flat, context).heights);
}

cv::Mat matrix_of(const Field<float>& land) {
    cv::Mat matrix(land.height(), land.width(), CV_32F);
    std::ranges::copy(land, matrix.ptr<float>());
    return matrix;
}

// A slope's energy is that of the height times its frequency squared. A window lets the
// land end softly.
double fine_share(const Field<float>& land) {
    cv::Mat window, spectrum;
    cv::createHanningWindow(window, {kSide, kSide}, CV_32F);
    const cv::Mat heights = matrix_of(land);
    const cv::Mat windowed = (heights - cv::mean(heights)[0]).mul(window);
    cv::dft(windowed, spectrum, cv::DFT_COMPLEX_OUTPUT);
    double fine = 0.0, all = 0.0;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const int u = std::min(x, kSide - x), v = std::min(y, kSide - y);
            const double waves = std::hypot(u, v);  // across the land
            const auto& amplitude = spectrum.at<cv::Vec2f>(y, x);
            const double energy = waves * waves * amplitude.dot(amplitude);
            all += energy;
            if (waves > kSide * kSpacing / kFine) fine += energy;
        }
    }
    return fine / all;
}

// Where the land is highest across the direction in which it bends down the most, within
// half a cell, and bends more than land does on average.
Field<std::uint8_t> crests_of(const Field<float>& land) {
    cv::Mat smooth;
    cv::GaussianBlur(matrix_of(land), smooth, {}, kSmooth / kSpacing);
    const cv::Mat& z = smooth;
    Field<std::uint8_t> crests(kSide, kSide);
    Field<float> bend(kSide, kSide);
    double mean_bend = 0.0;
    for (int y = 1; y + 1 < kSide; ++y) {
        for (int x = 1; x + 1 < kSide; ++x) {
            const auto at = [&](int i, int j) { return z.at<float>(y + j, x + i); };
            const float gx = 0.5f * (at(1, 0) - at(-1, 0));
            const float gy = 0.5f * (at(0, 1) - at(0, -1));
            const float xx = at(1, 0) - 2.0f * at(0, 0) + at(-1, 0);
            const float yy = at(0, 1) - 2.0f * at(0, 0) + at(0, -1);
            const float xy = 0.25f * (at(1, 1) - at(-1, 1) - at(1, -1) + at(-1, -1));
            // The least eigenvalue and its direction.
            const float least = 0.5f * (xx + yy) - std::hypot(0.5f * (xx - yy), xy);
            const float angle =
                0.5f * std::atan2(2.0f * xy, xx - yy) + 0.5f * std::numbers::pi_v<float>;
            const float nx = std::cos(angle), ny = std::sin(angle);
            const float off = -(gx * nx + gy * ny) / std::min(least, -1e-6f);
            bend(x, y) = std::max(0.0f, -least);
            mean_bend += bend(x, y) / static_cast<double>(bend.size());
            crests(x, y) = std::abs(off * nx) <= 0.5f && std::abs(off * ny) <= 0.5f;
        }
    }
    for (std::size_t i = 0; i < crests.size(); ++i) crests[i] &= bend[i] > mean_bend;
    return crests;
}

// Breadth-first over crest cells from one of them: the cell that comes last, and how far
// it is. Marks what it meets with `mark`.
struct Farthest {
    std::size_t cell;
    double metres;
};
Farthest farthest_from(std::size_t begin, const Field<std::uint8_t>& crests,
                       Field<int>& marks, int mark) {
    struct Entry {
        int x, y;
        double metres;
    };
    std::vector<Entry> queue{
        {static_cast<int>(begin % kSide), static_cast<int>(begin / kSide), 0.0}};
    marks[begin] = mark;
    for (std::size_t i = 0; i < queue.size(); ++i) {
        const Entry from = queue[i];
        for (int d = 0; d < 9; ++d) {
            const int dx = d % 3 - 1, dy = d / 3 - 1;
            const int x = from.x + dx, y = from.y + dy;
            if (!crests.contains(x, y) || !crests(x, y) || marks(x, y) == mark) continue;
            marks(x, y) = mark;
            queue.push_back({x, y, from.metres + kSpacing * std::hypot(dx, dy)});
        }
    }
    return {crests.index(queue.back().x, queue.back().y), queue.back().metres};
}

// Mean length of the longest crest lines: of each connected piece the way from one end to
// the other, without its branches.
double crest_length(const Field<float>& land) {
    constexpr std::size_t kLongest = 10;
    const Field<std::uint8_t> crests = crests_of(land);
    Field<int> marks(kSide, kSide);
    std::vector<double> lengths(kLongest);
    for (std::size_t cell = 0; cell < crests.size(); ++cell) {
        if (!crests[cell] || marks[cell] != 0) continue;
        const Farthest end = farthest_from(cell, crests, marks, 1);
        lengths.push_back(farthest_from(end.cell, crests, marks, 2).metres);
    }
    std::ranges::sort(lengths, std::greater());
    double sum = 0.0;
    for (std::size_t i = 0; i < kLongest; ++i) sum += lengths[i];
    return sum / kLongest;
}

template <class Land>
void print(const std::string& name, const Land& land) {
    double fine = 0.0, crests = 0.0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const Field<float> heights = land(seed);
        fine += fine_share(heights) / kSeeds;
        crests += crest_length(heights) / kSeeds;
    }
    fmt::print("{:6.1f}% {:7.1f}%  {}\n", 100.0 * fine,
               100.0 * crests / (kSide * kSpacing), name);
    std::fflush(stdout);
}

// Light from the north-west, 40 degrees high.
void shade(const Field<float>& land, Field<Rgb8>& picture, int left) {
    constexpr float kEast = -0.5417f, kNorth = 0.5417f, kUp = 0.6428f;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const auto at = [&](int i, int j) {
                return land(std::clamp(i, 0, kSide - 1), std::clamp(j, 0, kSide - 1));
            };
            const auto scale = static_cast<float>(0.5 / kSpacing);
            const float east = scale * (at(x + 1, y) - at(x - 1, y));
            const float north = scale * (at(x, y - 1) - at(x, y + 1));
            const float light = (kUp - east * kEast - north * kNorth) /
                                std::sqrt(1.0f + east * east + north * north);
            const auto grey = static_cast<std::uint8_t>(
                std::lround(20.0f + 225.0f * std::clamp(light, 0.0f, 1.0f)));
            picture(left + x, y) = {grey, grey, grey};
        }
    }
}

void write_hillshades(const std::string& file, const std::string& scene) {
    constexpr int kGap = 8;
    Field<Rgb8> picture(2 * kSide + kGap, kSide, {255, 255, 255});
    shade(ridged_multifractal(1), picture, 0);
    shade(distance_based(scene, kDetail, 1), picture, kSide + kGap);
    write_text(file, jpeg_of(picture, 34));
}

}  // namespace

int main(int argc, char** argv) try {
    std::vector<std::string> scenes(argv + 1, argv + argc);
    std::string picture;
    if (!scenes.empty() && scenes[0].ends_with(".jpg")) {
        picture = scenes[0];
        scenes.erase(scenes.begin());
    }
    if (scenes.empty()) {
        fmt::print(stderr, "ridged [PICTURE.jpg] SCENE.toml...\n");
        return 2;
    }
    fmt::print("{:>7} {:>8}\n", "fine", "crests");
    print("ridged multifractal", ridged_multifractal);
    for (const std::string& scene : scenes) {
        print(scene,
              [&](std::uint64_t seed) { return distance_based(scene, 0.0, seed); });
        print(scene + ", with detail",
              [&](std::uint64_t seed) { return distance_based(scene, kDetail, seed); });
    }
    if (!picture.empty()) write_hillshades(picture, scenes.back());
} catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(error.code());
}
