#include "synth/sketch/region.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "field/parallel.h"
#include "field/smoothstep.h"
#include "synth/sketch/bands.h"

namespace cydonia::sketch {
namespace {

// The distance to the loop at each sample inside it, in samples; 0 outside.
Field<float> distances(const geometry::Shape& loop, double spacing, int width,
                       int height) {
    constexpr int kParts = 16;  // subpixels of a sample
    std::vector<cv::Point> polygon;
    for (const Point2& p : loop.points)
        polygon.emplace_back(int(std::lround((p[0] / spacing - 0.5) * kParts)),
                             int(std::lround((height - p[1] / spacing - 0.5) * kParts)));
    cv::Mat inside = cv::Mat::zeros(height, width, CV_8U);
    cv::fillPoly(inside, std::vector{polygon}, cv::Scalar(255), cv::LINE_8, 4);
    Field<float> result(width, height);
    cv::Mat out(height, width, CV_32F, result.row(0).data());
    cv::distanceTransform(inside, out, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    return result;
}

}  // namespace

void roughen(Field<float>& land, double spacing, const geometry::Shape& loop,
             const NoiseLevels& noise, int levels, std::uint64_t seed) {
    const Field<float> inside = distances(loop, spacing, land.width(), land.height());
    const std::vector<Field<float>> scales = smoothed(land, levels);
    for (int i = levels / 2 + 1; i <= levels; ++i) {
        const Field<float> band =
            wavelet_noise(0, 0, land.width(), land.height(), i, levels, seed);
        const float sigma = float(noise.fitted[std::size_t(i - 1)]);
        const Field<float>&fine = scales[std::size_t(i)],
              &coarse = scales[std::size_t(i - 1)];
        const float width = std::exp2(float(levels - i + 1));
        parallel_for(land.height(), 16, [&](int y) {
            for (int x = 0; x < land.width(); ++x) {
                if (!(inside(x, y) > 0.0f)) continue;
                const float own = fine(x, y) - coarse(x, y);
                land(x, y) +=
                    smoothstep(0.0f, width, inside(x, y)) * (sigma * band(x, y) - own);
            }
        });
    }
}

}  // namespace cydonia::sketch
