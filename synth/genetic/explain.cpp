#include "synth/genetic/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cydonia::genetic {
namespace {

constexpr int kShortest = 400, kMostScale = 16;  // pixels, of a picture and of a cell
constexpr int kPanelWidth = 240, kPanelHeight = 200, kMargin = 12;
constexpr Rgb8 kPaper{255, 255, 255}, kFrame{200, 200, 200}, kFittest{20, 20, 20},
    kPopulation{150, 150, 150}, kCompatible{40, 90, 200}, kSimilar{200, 50, 40};

void draw_line(Field<Rgb8>& picture, double x0, double y0, double x1, double y1,
               Rgb8 colour) {
    const int steps =
        std::max(1, int(std::max(std::abs(x1 - x0), std::abs(y1 - y0)) * 2));
    for (int i = 0; i <= steps; ++i) {
        const double t = double(i) / steps;
        const int x = int(std::lround(x0 + t * (x1 - x0))),
                  y = int(std::lround(y0 + t * (y1 - y0)));
        if (picture.contains(x, y)) picture(x, y) = colour;
    }
}

}  // namespace

Field<Rgb8> relief_picture(const Field<float>& heights, double spacing) {
    const int shorter = std::max(1, std::min(heights.width(), heights.height()));
    const int scale = std::clamp(kShortest / shorter, 1, kMostScale);
    Field<Rgb8> picture(heights.width() * scale, heights.height() * scale);
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const int i = x / scale, j = y / scale;
            const int w = std::max(0, i - 1), e = std::min(heights.width() - 1, i + 1),
                      n = std::max(0, j - 1), s = std::min(heights.height() - 1, j + 1);
            const double across = std::max(1, e - w) * spacing,
                         down = std::max(1, s - n) * spacing;
            const double east = (heights(e, j) - heights(w, j)) / across,
                         south = (heights(i, s) - heights(i, n)) / down;
            // The light comes from the north-west, 45 degrees above the horizon.
            const double light = (0.5 * east + 0.5 * south + std::sqrt(0.5)) /
                                 std::sqrt(1.0 + east * east + south * south);
            const auto grey = std::uint8_t(std::clamp(255.0 * light, 0.0, 255.0));
            picture(x, y) = {grey, grey, grey};
        }
    return picture;
}

Field<Rgb8> fitness_picture(const std::vector<LevelDone>& levels) {
    int panels = 0;
    for (const LevelDone& level : levels) panels += !level.generations.empty();
    Field<Rgb8> picture(kMargin + panels * (kPanelWidth + kMargin),
                        kPanelHeight + 2 * kMargin, kPaper);
    int left = kMargin;
    for (const LevelDone& level : levels) {
        const auto& all = level.generations;
        if (all.empty()) continue;
        const auto at = [&](double cycle, double value, bool down) {
            return down ? kMargin + (1.0 - value) * kPanelHeight
                        : left + cycle / std::max<double>(1.0, double(all.size()) - 1.0) *
                                     kPanelWidth;
        };
        for (int tenth = 0; tenth <= 10; tenth += 2)
            draw_line(picture, left, at(0, tenth / 10.0, true), left + kPanelWidth,
                      at(0, tenth / 10.0, true), kFrame);
        const auto curve = [&](auto member, Rgb8 colour) {
            for (std::size_t i = 0; i + 1 < all.size(); ++i)
                draw_line(picture, at(double(i), 0, false), at(0, all[i].*member, true),
                          at(double(i + 1), 0, false), at(0, all[i + 1].*member, true),
                          colour);
        };
        curve(&Generation::mean_fitness, kPopulation);
        curve(&Generation::compatibility, kCompatible);
        curve(&Generation::similarity, kSimilar);
        curve(&Generation::fitness, kFittest);
        left += kPanelWidth + kMargin;
    }
    return picture;
}

std::string fitness_table(const std::vector<LevelDone>& levels) {
    std::string csv = "metres,cycle,fitness,mean_fitness,compatibility,similarity\n";
    for (const LevelDone& level : levels)
        for (std::size_t i = 0; i < level.generations.size(); ++i) {
            const Generation& g = level.generations[i];
            csv += fmt::format("{:g},{},{:.5f},{:.5f},{:.5f},{:.5f}\n", level.spacing, i,
                               g.fitness, g.mean_fitness, g.compatibility, g.similarity);
        }
    return csv;
}

}  // namespace cydonia::genetic
