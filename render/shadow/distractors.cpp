#include "render/shadow/distractors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <string>

namespace cydonia::render {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

// A polygon with corners on the unit circle. With `inner` below 1 every second corner is
// at that radius, which makes a star.
std::vector<cv::Point2d> corners(int count, double inner) {
    std::vector<cv::Point2d> result;
    const int points = inner < 1.0 ? 2 * count : count;
    for (int i = 0; i < points; ++i) {
        const double r = i % 2 == 1 && inner < 1.0 ? inner : 1.0;
        const double a = kTurn * i / points;
        result.push_back({r * std::sin(a), -r * std::cos(a)});
    }
    return result;
}

// The middle of a silhouette as shares of width and height, its radius as a share of the
// shorter side, and its rotation in radians.
struct Pose {
    double x, y, radius, turn;
};

class Drawing {
  public:
    Drawing(int width, int height, const Pose& pose)
        : mask_(width, height),
          matrix_(height, width, CV_8U, mask_.data()),
          middle_(pose.x * width, pose.y * height),
          radius_(pose.radius * std::min(width, height)),
          turn_(pose.turn) {}

    Field<std::uint8_t> mask() && { return std::move(mask_); }

    void polygon(const std::vector<cv::Point2d>& outline, int colour = 1) {
        std::vector<cv::Point> points;
        for (const cv::Point2d& p : outline) points.push_back(placed(p));
        cv::fillPoly(matrix_, std::vector{points}, colour);
    }
    void disc(double radius, int colour = 1) {
        cv::circle(matrix_, placed({0.0, 0.0}), pixels(radius), colour, cv::FILLED);
    }
    void crescent() {
        disc(1.0);
        cv::circle(matrix_, placed({0.45, 0.0}), pixels(0.8), 0, cv::FILLED);
    }
    void cross(double width) {
        polygon({{-1, -width}, {1, -width}, {1, width}, {-1, width}});
        polygon({{-width, -1}, {width, -1}, {width, 1}, {-width, 1}});
    }
    // Upright letters, as high as the diameter.
    void letters(const std::string& text) {
        constexpr auto kFont = cv::FONT_HERSHEY_SIMPLEX;
        const int thick = pixels(0.3);
        const double scale = cv::getFontScaleFromHeight(kFont, pixels(2.0), thick);
        int below = 0;
        const cv::Size size = cv::getTextSize(text, kFont, scale, thick, &below);
        const cv::Point start =
            placed({0.0, 0.0}) + cv::Point(-size.width / 2, size.height / 2);
        cv::putText(matrix_, text, start, kFont, scale, 1, thick);
    }

  private:
    int pixels(double length) const {
        return std::max(1, static_cast<int>(std::lround(length * radius_)));
    }
    cv::Point placed(const cv::Point2d& p) const {
        const double c = std::cos(turn_), s = std::sin(turn_);
        return {static_cast<int>(std::lround(middle_.x + radius_ * (c * p.x - s * p.y))),
                static_cast<int>(std::lround(middle_.y + radius_ * (s * p.x + c * p.y)))};
    }

    Field<std::uint8_t> mask_;
    cv::Mat matrix_;
    cv::Point2d middle_;
    double radius_, turn_;
};

struct Silhouette {
    Pose pose;
    void (*draw)(Drawing&);
};

// Placed as people place images: mostly near the middle, covering a tenth of the land to
// most of it.
constexpr Silhouette kSilhouettes[] = {
    {{0.50, 0.50, 0.20, 0.0}, [](Drawing& d) { d.letters("A"); }},
    {{0.30, 0.35, 0.22, 0.0}, [](Drawing& d) { d.letters("K"); }},
    {{0.65, 0.60, 0.25, 0.0}, [](Drawing& d) { d.letters("R"); }},
    {{0.45, 0.70, 0.15, 0.0}, [](Drawing& d) { d.letters("NO"); }},
    {{0.50, 0.30, 0.12, 0.0}, [](Drawing& d) { d.letters("CAVE"); }},
    {{0.70, 0.30, 0.22, 0.0}, [](Drawing& d) { d.letters("4"); }},
    {{0.35, 0.60, 0.25, 0.0}, [](Drawing& d) { d.letters("7"); }},
    {{0.50, 0.50, 0.15, 0.0}, [](Drawing& d) { d.letters("286"); }},
    {{0.50, 0.45, 0.30, 0.0}, [](Drawing& d) { d.polygon(corners(3, 1.0)); }},
    {{0.70, 0.70, 0.20, 0.4}, [](Drawing& d) { d.polygon(corners(4, 1.0)); }},
    {{0.30, 0.30, 0.20, 0.2}, [](Drawing& d) { d.polygon(corners(6, 1.0)); }},
    {{0.50, 0.50, 0.35, 0.3}, [](Drawing& d) { d.polygon(corners(4, 0.3)); }},
    {{0.60, 0.40, 0.25, 0.1}, [](Drawing& d) { d.polygon(corners(7, 0.5)); }},
    {{0.40, 0.55, 0.40, 0.0}, [](Drawing& d) { d.polygon(corners(12, 0.4)); }},
    {{0.50, 0.50, 0.35, 0.0}, [](Drawing& d) { d.cross(0.2); }},
    {{0.35, 0.70, 0.20, 0.8}, [](Drawing& d) { d.cross(0.3); }},
    {{0.30, 0.50, 0.20, 0.0}, [](Drawing& d) { d.disc(1.0); }},
    {{0.60, 0.55, 0.30, 0.0},
     [](Drawing& d) {
         d.disc(1.0);
         d.disc(0.6, 0);
     }},
    {{0.50, 0.50, 0.40, 2.0}, [](Drawing& d) { d.crescent(); }},
    {{0.75, 0.45, 0.15, 0.0}, [](Drawing& d) { d.crescent(); }},
};

}  // namespace

std::vector<Field<std::uint8_t>> distractors(int width, int height) {
    std::vector<Field<std::uint8_t>> result;
    for (const Silhouette& silhouette : kSilhouettes) {
        Drawing drawing(width, height, silhouette.pose);
        silhouette.draw(drawing);
        result.push_back(std::move(drawing).mask());
    }
    return result;
}

}  // namespace cydonia::render
