// What analysing a terrain library takes (docs/terrain-library.md): twenty models of 1024
// x 1024 samples at 10 m, at all levels; and whether the coarse scales would be faster as
// products of Fourier transforms, as which they take as long for any width.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "bench/measure.h"
#include "field/noise.h"
#include "synth/statistics/analysis.h"
#include "synth/statistics/scale_space.h"

using namespace cydonia;
using namespace cydonia::statistics;

// By OpenCV's transform of a whole field, of a size that suits it.
double fourier_seconds(const Field<float>& field) {
    const int size = cv::getOptimalDFTSize(field.width() + 128);
    cv::Mat padded = cv::Mat::zeros(size, size, CV_32F), spectrum;
    for (int y = 0; y < field.height(); ++y)
        std::copy_n(field.row(y).begin(), field.width(), padded.ptr<float>(y));
    const cv::Mat weights = cv::Mat::ones(size, size, CV_32F);  // stands for a Gaussian's
    const bench::Stopwatch watch;
    cv::dft(padded, spectrum);
    cv::mulSpectrums(spectrum, weights, spectrum, 0);
    cv::dft(spectrum, padded, cv::DFT_INVERSE | cv::DFT_SCALE | cv::DFT_REAL_OUTPUT);
    return watch.seconds();
}

// The shortest of a few times.
template <class Work>
double shortest(const Work& work) {
    double best = HUGE_VAL;
    for (int i = 0; i < 5; ++i) best = std::min(best, work());
    return best;
}

void compare_blurs(const Field<float>& field) {
    const double fourier = shortest([&] { return fourier_seconds(field); });
    for (const double deviation : {2.0, 8.0, 11.3137}) {
        const double separable = shortest([&] {
            const bench::Stopwatch watch;
            blurred(field, deviation);
            return watch.seconds();
        });
        fmt::print(
            "blurred by {:4.1f} samples: {:.1f} ms, by Fourier transforms {:.1f} ms\n",
            deviation, 1e3 * separable, 1e3 * fourier);
    }
    fmt::print("all nine scales: {:.1f} ms\n", 1e3 * shortest([&] {
                                                   const bench::Stopwatch watch;
                                                   scale_space(field);
                                                   return watch.seconds();
                                               }));
}

int main() {
    constexpr int kModels = 20, kSide = 1024;
    std::vector<Terrain> models;
    for (int i = 0; i < kModels; ++i) {
        NoiseOptions noise;
        noise.octaves = 8;
        noise.h = 0.9;
        Terrain& model = models.emplace_back();
        model.spacing = 10.0;
        model.heights = noise_field(noise, kSide, kSide, 400.0, std::uint64_t(i));
    }
    const bench::Stopwatch watch;
    std::size_t edges = 0;
    for (const Terrain& model : models)
        for (const double level : {90.0, 30.0, 10.0})
            edges +=
                analysis_of(at_level(model, level))[std::size_t(Quantity::kEdgeScale)]
                    .count;
    fmt::print("{} models of {} x {} at 90, 30 and 10 m: {:.1f} s ({} edges)\n", kModels,
               kSide, kSide, watch.seconds(), edges);
    compare_blurs(models[0].heights);
}
