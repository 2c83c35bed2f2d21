#include "synth/distance/curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "field/error.h"
#include "field/files.h"
#include "field/image.h"
#include "field/strokes.h"
#include "field/svg.h"

namespace cydonia::distance {
namespace {

constexpr int kSvgPixels = 512;  // a drawing has no pixels of its own
constexpr int kMostLines = 4096;
constexpr std::size_t kMostCurveBytes = kMostLines * 256u;
constexpr double kMost = 1e9;  // of x and f: their differences stay numbers

// Points and how messages name them.
struct Reading {
    std::vector<CurvePoint> points;
    std::vector<int> lines;  // of a table
    std::string name;
    const char* unit = "";  // of x

    Error error(std::size_t i, const std::string& flaw) const {
        if (!lines.empty()) return bad_request("{}:{}: {}", name, lines[i], flaw);
        return bad_request("{} at x = {}{}: {}", name, points[i].x, unit, flaw);
    }
};

// The middle of the dark line in each column, weighted by darkness, so that a smooth line
// is placed more finely than its pixels. Light greys are paper. The columns in which the
// line begins and ends contain only a corner of it, whose middle lies elsewhere, and are
// left out.
Reading traced(const Source& source, const std::string& what) {
    Reading reading{.points = {},
                    .lines = {},
                    .name = what + ": " + source.path.string(),
                    .unit = " pixels"};
    const Field<float> image =
        is_svg(source) ? read_grey_at(source, kSvgPixels, kSvgPixels) : read_grey(source);
    std::vector<double> weights;
    for (int x = 0; x < image.width(); ++x) {
        double sum = 0.0, weight = 0.0;
        for (int y = 0; y < image.height(); ++y) {
            const double dark = std::max(0.0, 0.75 - image(x, y));
            sum += dark * y;
            weight += dark;
        }
        if (weight <= 0.0) continue;
        reading.points.push_back({1.0 * x, -sum / weight});
        weights.push_back(weight);
    }
    while (weights.size() > 2 && weights.back() < 0.5 * weights[weights.size() - 2]) {
        weights.pop_back();
        reading.points.pop_back();
    }
    while (weights.size() > 2 && weights.front() < 0.5 * weights[1]) {
        weights.erase(weights.begin());
        reading.points.erase(reading.points.begin());
    }
    if (reading.points.size() < 2) {
        throw bad_request(
            "{}: a dark line over at least two columns of a light picture is needed, {} "
            "found",
            reading.name, reading.points.size());
    }
    return reading;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

bool parse(std::string_view text, double& value) {
    text = trimmed(text);
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && stop == end;
}

// "x, f(x)"
bool parse(std::string_view line, CurvePoint& point) {
    const std::size_t comma = line.find(',');
    return comma != std::string_view::npos && parse(line.substr(0, comma), point.x) &&
           parse(line.substr(comma + 1), point.f);
}

Reading tabled(const Source& source, const std::string& what) {
    Reading reading{
        .points = {}, .lines = {}, .name = what + ": " + source.path.string()};
    const std::string text = read_text(source.path, kMostCurveBytes);
    std::string_view rest = text;
    if (rest.starts_with("\xef\xbb\xbf")) rest.remove_prefix(3);  // a byte order mark
    for (int number = 1; !rest.empty(); ++number) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view whole = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        const std::string_view line = trimmed(whole.substr(0, whole.find('#')));
        if (number > kMostLines) {
            throw bad_request("{} has more than {} lines", reading.name, kMostLines);
        }
        if (line.empty()) continue;
        CurvePoint point{};
        if (!parse(line, point)) {
            throw bad_request("{}:{}: expected two numbers 'x, f(x)'", reading.name,
                              number);
        }
        reading.points.push_back(point);
        reading.lines.push_back(number);
    }
    return reading;
}

Reading listed(const Curve& curve, const std::string& what) {
    Reading reading{.points = {}, .lines = {}, .name = what};
    for (const auto& [x, f] : curve.points) reading.points.push_back({x, f});
    return reading;
}

Reading reading_of(const Curve& curve, const std::string& what) {
    const Reading reading = curve.image   ? traced(*curve.image, what)
                            : curve.table ? tabled(*curve.table, what)
                                          : listed(curve, what);
    const std::vector<CurvePoint>& points = reading.points;
    if (points.size() < 2) {
        throw bad_request("{}: at least two points x, f(x) are needed, {} found",
                          reading.name, points.size());
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!(std::abs(points[i].x) <= kMost && std::abs(points[i].f) <= kMost)) {
            throw reading.error(i, "the number is not finite or too large");
        }
        if (i > 0 && !(points[i].x > points[i - 1].x)) {
            throw reading.error(i, fmt::format("x must increase, but {} follows {}",
                                               points[i].x, points[i - 1].x));
        }
    }
    return reading;
}

}  // namespace

std::vector<CurvePoint> points_of(const Curve& curve, const std::string& what) {
    return reading_of(curve, what).points;
}

std::vector<CurvePoint> falling_points_of(const Curve& curve, const std::string& what) {
    Reading reading = reading_of(curve, what);
    std::vector<CurvePoint>& points = reading.points;
    const double tolerance = curve.image ? 1.0 : 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points[i].f > points[i - 1].f + tolerance) {
            throw reading.error(
                i, "rises, but a cross-section must fall from the feature outward");
        }
        points[i].f = std::min(points[i].f, points[i - 1].f);
    }
    if (!(points.back().f < points.front().f)) {
        throw bad_request("{} is flat: it must fall from the feature outward",
                          reading.name);
    }
    return points;
}

std::vector<CurvePoint> unit_points_of(const Curve& curve, const std::string& what) {
    std::vector<CurvePoint> points = points_of(curve, what);
    const double first = points.front().x, length = points.back().x - first;
    const auto [low, high] = std::ranges::minmax_element(points, {}, &CurvePoint::f);
    const double least = low->f, range = high->f - least;
    for (CurvePoint& point : points) {
        point.x = (point.x - first) / length;
        point.f = range > 0.0 ? (point.f - least) / range : 1.0;
    }
    return points;
}

}  // namespace cydonia::distance
