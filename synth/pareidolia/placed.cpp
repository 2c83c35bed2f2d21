#include "synth/pareidolia/placed.h"

#include <algorithm>
#include <cmath>

#include "field/image.h"
#include "field/parallel.h"
#include "field/sample.h"

namespace cydonia::pareidolia {
namespace {

constexpr int kSamples = 4;         // a cell, each way
constexpr double kFinest = 4096.0;  // pixels along the longer side of a drawing

bool covers(const Frame& frame, int width, int height) {
    const auto near = [](double a, double b) { return std::abs(a - b) < 0.5; };
    return frame.rotation == 0.0 && near(frame.width, width) &&
           near(frame.height, height) && std::abs(frame.x - 0.5 * width) < 1e-6 &&
           std::abs(frame.y - 0.5 * height) < 1e-6;
}

int pixels(double length) { return std::max(1, static_cast<int>(std::lround(length))); }

}  // namespace

Frame frame_of(const Picture& picture, const Placing& placing, int width, int height) {
    const double fit = std::min(width / picture.width, height / picture.height);
    return {placing.position[0] * width, (1.0 - placing.position[1]) * height,
            fit * placing.scale * picture.width, fit * placing.scale * picture.height,
            placing.rotation};
}

Size finest(const Picture& picture, const Frame& frame) {
    const double finer =
        std::clamp(kFinest / std::max(frame.width, frame.height), 1e-6, double(kSamples));
    Size size{pixels(finer * frame.width), pixels(finer * frame.height)};
    if (picture.has_pixels)
        size = {std::min(size.width, pixels(picture.width)),
                std::min(size.height, pixels(picture.height))};
    return size;
}

Field<float> placed(const Picture& picture, const Frame& frame, int width, int height) {
    if (covers(frame, width, height)) return picture.lightness(width, height);

    const Size size = finest(picture, frame);
    const Field<float> image = picture.lightness(size.width, size.height);
    // Turns cells, counted from the frame's middle, into pixels of the image.
    const double c = std::cos(frame.rotation), s = std::sin(frame.rotation);
    const double across = size.width / frame.width, down = size.height / frame.height;
    const auto lightness = [&](double x, double y) {
        const double u = (c * x + s * y) * across + 0.5 * size.width;
        const double v = (c * y - s * x) * down + 0.5 * size.height;
        if (u < 0.0 || v < 0.0 || u > size.width || v > size.height) return 1.0f;
        return bilinear(image, u - 0.5, v - 0.5);
    };
    // The samples need not be finer than the image's pixels.
    const int samples = std::clamp(
        static_cast<int>(std::ceil(std::max(across, down) - 1e-6)), 2, kSamples);
    const double reach = 0.5 * std::hypot(frame.width, frame.height) + 1.0;

    Field<float> cells(width, height, 1.0f);
    parallel_for(height, 8, [&](int row) {
        for (int column = 0; column < width; ++column) {
            const double x = column - frame.x, y = row - frame.y;
            if (std::abs(x) > reach || std::abs(y) > reach) continue;
            double sum = 0.0;
            for (int j = 0; j < samples; ++j)
                for (int i = 0; i < samples; ++i)
                    sum += lightness(x + (i + 0.5) / samples, y + (j + 0.5) / samples);
            cells(column, row) = static_cast<float>(sum / (samples * samples));
        }
    });
    return cells;
}

}  // namespace cydonia::pareidolia
