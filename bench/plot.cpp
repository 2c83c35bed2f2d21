#include "bench/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "field/files.h"
#include "field/image.h"
#include "field/svg.h"

namespace cydonia::bench {
namespace {

constexpr int kWidth = 480, kHeight = 340;  // of one plot, pixels
constexpr double kLeft = 72.0, kRight = 16.0, kTop = 34.0, kBottom = 46.0;

struct Tick {
    double value;
    bool labelled;
};

std::vector<Tick> decades(const Axis& axis) {
    std::vector<Tick> ticks;
    for (double decade = std::pow(10.0, std::floor(std::log10(axis.from)));
         decade <= axis.to; decade *= 10.0) {
        for (int i = 1; i < 10; ++i) {
            const double value = i * decade;
            if (value < 0.999 * axis.from || value > 1.001 * axis.to) continue;
            ticks.push_back({value, i == 1});
        }
    }
    return ticks;
}

// Four to nine round numbers.
std::vector<Tick> round_numbers(const Axis& axis) {
    const double span = axis.to - axis.from;
    double step = std::pow(10.0, std::floor(std::log10(span)));
    if (span / step < 2.0) step /= 5.0;
    if (span / step < 4.0) step /= 2.0;
    std::vector<Tick> ticks;
    for (double i = std::ceil(axis.from / step); i * step <= axis.to + 1e-9 * span; ++i) {
        ticks.push_back({i * step, true});
    }
    return ticks;
}

std::vector<Tick> ticks_of(const Axis& axis) {
    return axis.logarithmic ? decades(axis) : round_numbers(axis);
}

// 0 to 1 along the axis.
double share(const Axis& axis, double value) {
    if (!axis.logarithmic) return (value - axis.from) / (axis.to - axis.from);
    return std::log(value / axis.from) / std::log(axis.to / axis.from);
}

double x_of(const Plot& plot, double value) {
    return kLeft + (kWidth - kLeft - kRight) * share(plot.x, value);
}
double y_of(const Plot& plot, double value) {
    return kHeight - kBottom - (kHeight - kTop - kBottom) * share(plot.y, value);
}

std::string frame_of(const Plot& plot) {
    const double south = kHeight - kBottom, east = kWidth - kRight;
    std::string text;
    for (const auto& [value, labelled] : ticks_of(plot.x)) {
        const double x = x_of(plot, value);
        text += fmt::format("<path d='M{:.1f} {} V{}' stroke='{}'/>\n", x, south, kTop,
                            labelled ? "#d8d8d8" : "#efefef");
        if (!labelled) continue;
        text += fmt::format("<text x='{:.1f}' y='{}' text-anchor='middle'>{:g}</text>\n",
                            x, south + 17.0, value);
    }
    for (const auto& [value, labelled] : ticks_of(plot.y)) {
        const double y = y_of(plot, value);
        text += fmt::format("<path d='M{} {:.1f} H{}' stroke='{}'/>\n", kLeft, y, east,
                            labelled ? "#d8d8d8" : "#efefef");
        if (!labelled) continue;
        text += fmt::format("<text x='{}' y='{:.1f}' text-anchor='end'>{:g}</text>\n",
                            kLeft - 6.0, y + 4.0, value);
    }
    text += fmt::format("<path d='M{} {} V{} H{}' fill='none' stroke='#444'/>\n", kLeft,
                        kTop, south, east);
    text += fmt::format("<text x='{}' y='20' font-weight='bold'>{}</text>\n", kLeft,
                        plot.title);
    text += fmt::format("<text x='{}' y='{}' text-anchor='middle'>{}</text>\n",
                        0.5 * (kLeft + east), kHeight - 10, plot.x.label);
    text += fmt::format(
        "<text transform='translate(14 {}) rotate(-90)' text-anchor='middle'>{}</text>\n",
        0.5 * (kTop + south), plot.y.label);
    return text;
}

// Dots are the round ends of lines without length: one element for thousands.
std::string dots_of(const Plot& plot, const Plot::Points& points) {
    std::string path;
    for (const auto& [x, y] : points.at) {
        path += fmt::format("M{:.1f} {:.1f}h0", x_of(plot, x), y_of(plot, y));
    }
    return fmt::format(
        "<path d='{}' stroke='{}' stroke-width='{}' stroke-linecap='round'/>\n", path,
        points.colour, 2.0 * points.radius);
}

std::string bars_of(const Plot& plot, const Plot::Bars& bars) {
    std::string text;
    for (const auto& [begin, height] : bars.at) {
        const double x = x_of(plot, begin), y = y_of(plot, height);
        text += fmt::format(
            "<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}' fill='{}'/>\n",
            x + 0.5, y, x_of(plot, begin + bars.width) - x - 1.0,
            y_of(plot, plot.y.from) - y, bars.colour);
    }
    return text;
}

std::string legend_of(const Plot& plot) {
    std::string text;
    double y = kTop + 14.0;
    for (const Plot::Points& points : plot.points) {
        if (points.name.empty()) continue;
        text += fmt::format(
            "<circle cx='{}' cy='{}' r='{}' fill='{}'/><text x='{}' y='{}'>{}</text>\n",
            kLeft + 14.0, y - 4.0, points.radius, points.colour, kLeft + 24.0, y,
            points.name);
        y += 17.0;
    }
    return text;
}

std::string drawing_of(const std::vector<Plot>& plots) {
    std::string text = fmt::format(
        "<svg xmlns='http://www.w3.org/2000/svg' width='{}' height='{}' "
        "font-family='sans-serif' font-size='13'>\n"
        "<rect width='100%' height='100%' fill='white'/>\n",
        kWidth * plots.size(), kHeight);
    for (std::size_t i = 0; i < plots.size(); ++i) {
        const Plot& plot = plots[i];
        text += fmt::format("<g transform='translate({} 0)'>\n{}", kWidth * i,
                            frame_of(plot));
        for (const auto& bars : plot.bars) text += bars_of(plot, bars);
        for (const auto& points : plot.points) text += dots_of(plot, points);
        text += legend_of(plot) + "</g>\n";
    }
    return text + "</svg>\n";
}

}  // namespace

void write_plots(const std::filesystem::path& folder, const std::string& name,
                 const std::vector<Plot>& plots) {
    const std::string drawing = drawing_of(plots);
    make_folder(folder);
    write_text(folder / (name + ".svg"), drawing);
    const Field<Rgba8> pixels =
        drawn_svg(name, drawing, kWidth * static_cast<int>(plots.size()), kHeight,
                  SvgEdges::kSmooth);
    Field<Rgb8> opaque(pixels.width(), pixels.height());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        opaque[i] = {pixels[i][0], pixels[i][1], pixels[i][2]};
    }
    write_png(folder / (name + ".png"), opaque);
}

}  // namespace cydonia::bench
