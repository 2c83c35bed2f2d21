#include "render/shadow/lineup.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "field/error.h"
#include "render/shadow/distractors.h"

namespace cydonia::render {

namespace {

constexpr int kLonger = 128;         // pixels
constexpr double kBroad = 1.0 / 16;  // of the shorter side

// Normalised, so that a dot product is a correlation; all zeros for an empty mask.
cv::Mat seen(const Field<std::uint8_t>& mask) {
    const double scale =
        static_cast<double>(kLonger) / std::max(mask.width(), mask.height());
    const auto pixels = [&](int cells) {
        return std::max(1, static_cast<int>(std::lround(cells * scale)));
    };
    const cv::Mat cells(mask.height(), mask.width(), CV_8U,
                        const_cast<std::uint8_t*>(mask.data()));
    cv::Mat small, broad;
    cells.convertTo(small, CV_32F);
    cv::resize(small, small, {pixels(mask.width()), pixels(mask.height())}, 0.0, 0.0,
               cv::INTER_AREA);
    cv::GaussianBlur(small, broad, {}, kBroad * std::min(small.cols, small.rows), 0.0,
                     cv::BORDER_REPLICATE);
    cv::Mat fine = small - broad;
    fine -= cv::mean(fine)[0];
    const double length = cv::norm(fine);
    return length > 1e-6 ? cv::Mat(fine / length) : cv::Mat(0.0 * fine);
}

}  // namespace

struct Lineup::Seen {
    int width, height;
    cv::Mat target;
    std::vector<cv::Mat> others;
};

Lineup::Lineup(const Field<std::uint8_t>& target)
    : seen_(new Seen{target.width(), target.height(), seen(target), {}}) {
    for (const auto& other : distractors(target.width(), target.height()))
        seen_->others.push_back(seen(other));
}
Lineup::~Lineup() = default;

double Lineup::standing_out(const Field<std::uint8_t>& cast) const {
    if (cast.width() != seen_->width || cast.height() != seen_->height)
        throw bad_request("a cast of {}x{} samples does not fit a target of {}x{} cells",
                          cast.width(), cast.height(), seen_->width, seen_->height);
    const cv::Mat shown = seen(cast);
    const double n = static_cast<double>(seen_->others.size());
    double mean = 0.0, square = 0.0;
    for (const cv::Mat& other : seen_->others) {
        const double r = shown.dot(other);
        mean += r / n;
        square += r * r / n;
    }
    const double spread = std::sqrt(std::max(0.0, square - mean * mean));
    return spread > 1e-6 ? (shown.dot(seen_->target) - mean) / spread : 0.0;
}

}  // namespace cydonia::render
