#include "synth/pareidolia/constrained/membrane.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>
#include <vector>

#include "field/parallel.h"
#include "synth/pareidolia/constrained/transpose.h"

namespace cydonia::pareidolia {
namespace {

// OpenCV transforms even lengths only, and quickly those without large prime factors. The
// land is padded, and the padding is free and dropped afterwards.
int transform_length(int n) { return 2 * cv::getOptimalDFTSize((n + 1) / 2); }

void transform_rows(Field<float>& field, int flags) {
    constexpr int kBand = 16;  // rows that one thread takes at a time
    parallel_for((field.height() + kBand - 1) / kBand, [&](int band) {
        const int first = band * kBand;
        cv::Mat rows(std::min(kBand, field.height() - first), field.width(), CV_32F,
                     field.row(first).data());
        cv::dct(rows, rows, flags | cv::DCT_ROWS);
    });
}

Field<float> resized_with_zeros(const Field<float>& in, int width, int height) {
    Field<float> out(width, height);
    for (int y = 0; y < std::min(height, in.height()); ++y)
        std::copy_n(in.row(y).begin(), std::min(width, in.width()), out.row(y).begin());
    return out;
}

}  // namespace

Membrane::Membrane(int width, int height, const Stiffness& stiffness, double pull)
    : response_(transform_length(height), transform_length(width)) {
    const auto frequencies = [](int n) {
        std::vector<double> q(static_cast<std::size_t>(n));
        for (int k = 0; k < n; ++k)
            q[static_cast<std::size_t>(k)] =
                2.0 - 2.0 * std::cos(std::numbers::pi * k / n);
        return q;
    };
    const auto qx = frequencies(response_.height()), qy = frequencies(response_.width());
    parallel_for(response_.height(), 16, [&](int x) {
        for (int y = 0; y < response_.width(); ++y) {
            const double q =
                qx[static_cast<std::size_t>(x)] + qy[static_cast<std::size_t>(y)];
            response_(y, x) =
                static_cast<float>(1.0 / ((stiffness.bend * q + stiffness.slope) * q +
                                          stiffness.keep + pull));
        }
    });
}

void Membrane::solve(Field<float>& force) const {
    const int width = force.width(), height = force.height();
    const bool fits = width == response_.height() && height == response_.width();
    if (!fits) force = resized_with_zeros(force, response_.height(), response_.width());
    transform_rows(force, 0);
    Field<float> turned = transposed(force);
    transform_rows(turned, 0);
    parallel_for(turned.height(), 64, [&](int y) {
        for (int x = 0; x < turned.width(); ++x) turned(x, y) *= response_(x, y);
    });
    transform_rows(turned, cv::DCT_INVERSE);
    force = transposed(turned);
    transform_rows(force, cv::DCT_INVERSE);
    if (!fits) force = resized_with_zeros(force, width, height);
}

}  // namespace cydonia::pareidolia
