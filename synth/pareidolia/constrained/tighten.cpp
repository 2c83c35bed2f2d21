#include "synth/pareidolia/constrained/tighten.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace cydonia::pareidolia {
namespace {

// The increase of a margin where a whole cell is wrong, and the greatest margin.
constexpr float kMore = 0.2f, kMost = 0.6f;

// How much of each cell is wrong, 0 to 1.
struct Share {
    Field<float> lit, dark;
};

Share shares(const Demand& demand, const Field<std::uint8_t>& cast) {
    const Field<Part>& parts = demand.parts;
    const int rays = cast.width() / parts.width();
    const float one = 1.0f / static_cast<float>(rays * rays);
    Share share{Field<float>(parts.width(), parts.height()),
                Field<float>(parts.width(), parts.height())};
    for (int y = 0; y < cast.height(); ++y)
        for (int x = 0; x < cast.width(); ++x) {
            const Part part = parts(x / rays, y / rays);
            if (part == Part::kShadow && !cast(x, y))
                share.lit(x / rays, y / rays) += one;
            if (part == Part::kLit && cast(x, y)) share.dark(x / rays, y / rays) += one;
        }
    return share;
}

// Beside shadow no margin corrects ground that is dark: a crest is dark beyond its own
// sample, and margins along the side of a shadow would add up to a cliff.
void forgive_edges(const Demand& demand, Field<float>& dark) {
    const auto shadow = [&](int x, int y) {
        return demand.parts.contains(x, y) && demand.parts(x, y) == Part::kShadow;
    };
    for (int y = 0; y < dark.height(); ++y)
        for (int x = 0; x < dark.width(); ++x)
            if (shadow(x - 1, y) || shadow(x + 1, y) || shadow(x, y - 1) ||
                shadow(x, y + 1))
                dark(x, y) = 0.0f;
}

void widen(Field<float>& margin, const Field<float>& wrong) {
    cv::Mat around;
    cv::dilate(
        cv::Mat(wrong.height(), wrong.width(), CV_32F, const_cast<float*>(wrong.data())),
        around, cv::Mat());
    const auto* more = around.ptr<float>();
    for (std::size_t i = 0; i < margin.size(); ++i)
        if (more[i] > 0.0f)
            margin[i] = std::max(margin[i], std::min(kMost, margin[i] + kMore * more[i]));
}

}  // namespace

Wrong wrong_in(const Demand& demand, const Field<std::uint8_t>& cast) {
    const int rays = cast.width() / demand.parts.width();
    Wrong wrong;
    for (int y = 0; y < cast.height(); ++y)
        for (int x = 0; x < cast.width(); ++x) {
            const Part part = demand.parts(x / rays, y / rays);
            wrong.lit += part == Part::kShadow && !cast(x, y);
            wrong.dark += part == Part::kLit && cast(x, y);
        }
    return wrong;
}

void tighten(Demand& demand, const Field<std::uint8_t>& cast) {
    Share wrong = shares(demand, cast);
    forgive_edges(demand, wrong.dark);
    widen(demand.light, wrong.dark);
    widen(demand.crisp, wrong.lit);
}

}  // namespace cydonia::pareidolia
