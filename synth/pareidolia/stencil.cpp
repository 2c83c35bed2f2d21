#include "synth/pareidolia/stencil.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "field/image.h"

namespace cydonia::pareidolia {
namespace {

// Lengths are pixels of the drawing.
constexpr double kLight = 0.15 * kStencilSide;  // how far light over a scene is even
constexpr double kLine = 2.4;                   // of lines
constexpr double kOutline = 2.5;                // how smooth outlines are
constexpr int kSpeck = kStencilSide * kStencilSide / 4000;  // pixels that no one misses

cv::Mat blurred(const cv::Mat& image, double sigma) {
    cv::Mat result;
    cv::GaussianBlur(image, result, {}, sigma, sigma, cv::BORDER_REPLICATE);
    return result;
}

// The value below which this share of the pixels lies.
float quantile(const cv::Mat& image, double share) {
    std::vector<float> values(image.begin<float>(), image.end<float>());
    const auto at =
        values.begin() + static_cast<std::ptrdiff_t>(share * double(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

// Removes half of the slow change of light, and stretches the rest over 0 to 1.
cv::Mat evenly_lit(const cv::Mat& photograph) {
    cv::Mat even = photograph - 0.5 * blurred(photograph, kLight);
    const float black = quantile(even, 0.01), white = quantile(even, 0.99);
    even = (even - black) / std::max(white - black, 1e-3f);
    return cv::max(cv::min(even, 1.0), 0.0);
}

// Flattens everything but edges with a bilateral filter, several times (Winnemoeller et
// al. 2006, "Real-time video abstraction").
cv::Mat flattened(cv::Mat image) {
    for (int pass = 0; pass < 2; ++pass) {
        cv::Mat flat;
        cv::bilateralFilter(image, flat, 13, 0.12, 5.0, cv::BORDER_REPLICATE);
        image = flat;
    }
    return image;
}

// Otsu 1979: the threshold that separates two classes best.
double otsu(const cv::Mat& image) {
    cv::Mat levels, unused;
    image.convertTo(levels, CV_8U, 255.0);
    return cv::threshold(levels, unused, 0.0, 255.0, cv::THRESH_OTSU) / 255.0;
}

// Extended difference of Gaussians (Winnemoeller et al. 2012, eq. 7): emphasises the
// edges of the image, so that one threshold keeps dark areas and contours.
cv::Mat with_edges(const cv::Mat& image) {
    constexpr double kWider = 1.6, kStrength = 18.0;  // k, p
    return (1.0 + kStrength) * blurred(image, kLine) -
           kStrength * blurred(image, kWider * kLine);
}

// Islands of either tone that are smaller than a speck take the other tone.
void remove_specks(cv::Mat& ink) {
    for (int tone = 0; tone < 2; ++tone) {
        cv::Mat labels, figures, centres;
        const int count = cv::connectedComponentsWithStats(ink, labels, figures, centres,
                                                           tone == 0 ? 8 : 4);
        for (int y = 0; y < ink.rows; ++y)
            for (int x = 0; x < ink.cols; ++x) {
                const int label = labels.at<int>(y, x);
                if (label > 0 && label < count &&
                    figures.at<int>(label, cv::CC_STAT_AREA) < kSpeck)
                    ink.at<unsigned char>(y, x) = 0;
            }
        cv::bitwise_not(ink, ink);
    }
}

}  // namespace

Field<float> stencil(const Field<float>& photograph, double darkness) {
    const double scale =
        double(kStencilSide) / std::max(photograph.width(), photograph.height());
    const auto pixels = [&](int side) {
        return std::max(1, static_cast<int>(std::lround(scale * side)));
    };
    Field<float> drawing =
        resized(photograph, pixels(photograph.width()), pixels(photograph.height()));
    const cv::Mat image(drawing.height(), drawing.width(), CV_32F, drawing.data());

    const cv::Mat flat = flattened(evenly_lit(image));
    const cv::Mat edges = with_edges(flat);
    const double threshold = otsu(flat) + (darkness - 0.5);
    cv::Mat ink = edges < threshold;
    // Smooths the outlines: each pixel takes the tone of most of its neighbourhood.
    cv::Mat soft;
    ink.convertTo(soft, CV_32F, 1.0 / 255.0);
    ink = blurred(soft, kOutline) > 0.5;
    remove_specks(ink);
    ink.convertTo(soft, CV_32F, -1.0 / 255.0, 1.0);
    soft = blurred(soft, 0.5 * kOutline);
    for (int y = 0; y < drawing.height(); ++y)
        std::copy_n(soft.ptr<float>(y), drawing.width(), drawing.row(y).begin());
    return drawing;
}

}  // namespace cydonia::pareidolia
