#include "synth/sketch/sight.h"

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "field/sample.h"
#include "field/svg_camera.h"
#include "synth/geometry/plane.h"

namespace cydonia::sketch {
namespace {

constexpr int kValues = 16384;  // of a stroke
constexpr double kShortest =
    1.0 / 2048;  // share of the page: lines are divided into such parts
constexpr std::size_t kMostPoints = 4'000'000;  // of strokes
constexpr int kNarrowest = 8,
              kBelow = 10;      // values of the narrowest filter; lines below a stroke
constexpr double kStep = 0.25;  // samples, along a line of sight

using geometry::dot;
using geometry::from_to;

double height_at(const Field<float>& land, double spacing, const Point2& p) {
    return bilinear(land, p[0] / spacing - 0.5, land.height() - p[1] / spacing - 0.5);
}

// The part of a line of sight over the terrain, as distances from the eye in metres.
std::optional<std::array<double, 2>> over_terrain(const Field<float>& land,
                                                  double spacing, const Point2& eye,
                                                  const Point2& direction) {
    double from = 0.0, to = HUGE_VAL;
    const Point2 size{spacing * land.width(), spacing * land.height()};
    for (const std::size_t axis : {0u, 1u}) {
        if (std::abs(direction[axis]) < 1e-12) {
            if (eye[axis] < 0.0 || eye[axis] > size[axis]) return {};
            continue;
        }
        const double a = -eye[axis] / direction[axis],
                     b = (size[axis] - eye[axis]) / direction[axis];
        from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
    }
    if (!(from < to)) return {};
    return std::array{from, to};
}

Point2 on_way(const Point2& eye, const Point2& direction, double metres) {
    return {eye[0] + metres * direction[0], eye[1] + metres * direction[1]};
}

// The minimum over so many values on both sides of each, then averaged over as many; it
// is nowhere above the line.
Field<float> lowered(const Field<float>& line, int half) {
    const int n = line.width();
    Field<float> least = line;
    for (int done = 0; done < half;) {
        const int step = std::min(std::max(done, 1), half - done);
        Field<float> wider = least;
        for (int i = 0; i < n; ++i)
            wider[std::size_t(i)] =
                std::min(least[std::size_t(std::max(0, i - step))],
                         least[std::size_t(std::min(n - 1, i + step))]);
        for (int i = 0; i < n; ++i)
            wider[std::size_t(i)] =
                std::min(wider[std::size_t(i)], least[std::size_t(i)]);
        least = std::move(wider), done += step;
    }
    std::vector<double> sums(std::size_t(n) + 1, 0.0);
    for (int i = 0; i < n; ++i)
        sums[std::size_t(i) + 1] = sums[std::size_t(i)] + double(least[std::size_t(i)]);
    Field<float> mean(n, 1);
    for (int i = 0; i < n; ++i) {
        const auto from = std::size_t(std::max(0, i - half)),
                   to = std::size_t(std::min(n, i + half + 1));
        // Beyond its ends the line continues level.
        const double before = std::max(0, half - i) * double(least[0]),
                     after = std::max(0, i + half + 1 - n) *
                             double(least[std::size_t(n - 1)]);
        mean[std::size_t(i)] =
            float((sums[to] - sums[from] + before + after) / (2 * half + 1));
    }
    return mean;
}

}  // namespace

Sight::Sight(const View& view, const std::string& name, Progress& progress) {
    const auto camera = svg_camera(view.drawing);
    if (!camera)
        throw bad_request(
            "{}: '{}': the drawing names no camera; draw in one that cydonia "
            "frame-for-sketch made",
            view.drawing.name(), name);
    camera_ = *camera;
    const CameraAxes axes(camera_);
    ahead_ = geometry::unit_of({axes.forward.x, axes.forward.y});
    right_ = {ahead_[1], -ahead_[0]};
    const double wide = std::tan(0.5 * camera_.field_of_view);
    const double high = wide * camera_.height / camera_.width;

    std::vector<std::vector<Point2>> strokes;
    const std::vector<SvgPath> paths = strokes_of(view.drawing, view.id, name);
    const auto in_frame = [](const Point2& p) {
        return std::min(p[0], p[1]) >= 0.0 && std::max(p[0], p[1]) <= 1.0;
    };
    if (std::ranges::none_of(paths, [&](const SvgPath& path) {
            return std::ranges::any_of(path.points, in_frame);
        }))
        throw bad_request("{}: '{}': its stroke is outside the frame; draw on the page",
                          view.drawing.name(), name);
    std::size_t count = 0;
    for (const SvgPath& path : paths) {
        auto& stroke = strokes.emplace_back();
        const auto add = [&](const Point2& p) {
            const Vec3 d = axes.forward + (2.0 * p[0] - 1.0) * wide * axes.right +
                           (1.0 - 2.0 * p[1]) * high * axes.up;
            const double forward = dot({d.x, d.y}, ahead_);
            if (!(forward > 1e-3))
                throw bad_request(
                    "{}: '{}': its stroke runs below the camera, where there is no "
                    "skyline",
                    view.drawing.name(), name);
            stroke.push_back({std::atan2(dot({d.x, d.y}, right_), forward),
                              d.z / std::hypot(d.x, d.y)});
        };
        add(path.points[0]);
        for (std::size_t i = 1; i < path.points.size(); ++i) {
            const Point2 &a = path.points[i - 1], &b = path.points[i];
            const int parts =
                std::clamp(int(std::ceil(geometry::distance(a, b) / kShortest)), 1, 8192);
            if ((count += std::size_t(parts)) > kMostPoints)
                throw bad_request("{}: '{}': its strokes are too long: draw on the page",
                                  view.drawing.name(), name);
            for (int k = 1; k <= parts; ++k)
                add(geometry::between(a, b, double(k) / parts));
        }
    }
    double left = HUGE_VAL, right = -HUGE_VAL;
    for (const auto& stroke : strokes)
        for (const Point2& p : stroke)
            left = std::min(left, p[0]), right = std::max(right, p[0]);
    if (!(right - left > 1e-5))
        throw bad_request("{}: '{}': the silhouette is upright and has no width",
                          view.drawing.name(), name);
    line_ = line_of(strokes, kValues);
    if (line_.folds)
        progress.note(fmt::format(
            "'{}': its silhouette folds back; what is drawn last counts there", name));
    for (int i = 0; i < kBelow; ++i)
        below_.push_back(lowered(line_.values, kNarrowest << i));
}

std::optional<double> Sight::azimuth_of(const Point2& place) const {
    const Point2 d = from_to(eye(), place);
    const double forward = dot(d, ahead_);
    if (!(forward > 0.0)) return {};
    return std::atan2(dot(d, right_), forward);
}

double Sight::at(const Field<float>& line, double azimuth) const {
    const double k =
        std::clamp((azimuth - line_.left) / (line_.right - line_.left), 0.0, 1.0) *
        (kValues - 1);
    const auto i = std::min(std::size_t(k), std::size_t(kValues - 2));
    return line[i] + (k - double(i)) * (double(line[i + 1]) - double(line[i]));
}

std::optional<double> Sight::height_over(const Point2& place) const {
    const auto azimuth = azimuth_of(place);
    // The ends themselves are included.
    const double margin = 1e-9 + 1e-6 * (line_.right - line_.left);
    if (!azimuth || *azimuth < line_.left - margin || *azimuth > line_.right + margin)
        return {};
    return eye_height() + at(line_.values, *azimuth) * geometry::distance(eye(), place);
}

std::optional<double> Sight::height_below(const Point2& place, double metres) const {
    const auto azimuth = azimuth_of(place);
    if (!azimuth) return {};
    const double distance = geometry::distance(eye(), place);
    // Interpolated between two lines, of which the stroke is the first.
    const double values =
        metres / distance / (line_.right - line_.left) * (kValues - 1) / kNarrowest;
    const double level = std::clamp(std::log2(1.0 + values), 0.0, double(kBelow));
    const auto i = std::min(std::size_t(level), std::size_t(kBelow - 1));
    const double upper = at(i == 0 ? line_.values : below_[i - 1], *azimuth),
                 lower = at(below_[i], *azimuth);
    return eye_height() + (upper + (level - double(i)) * (lower - upper)) * distance;
}

Sight::Ray Sight::ray_at(double azimuth, double rise) const {
    return {{std::cos(azimuth) * ahead_[0] + std::sin(azimuth) * right_[0],
             std::cos(azimuth) * ahead_[1] + std::sin(azimuth) * right_[1]},
            rise};
}

std::array<Sight::Ray, 2> Sight::ends() const {
    return {ray_at(line_.left, line_.values[0]),
            ray_at(line_.right, line_.values[std::size_t(kValues - 1)])};
}

double Sight::row_of(double azimuth, double rise) const {
    const Ray ray = ray_at(azimuth, rise);
    const CameraAxes axes(camera_);
    const Vec3 d{ray.direction[0], ray.direction[1], rise};
    return dot(d, axes.up) / dot(d, axes.forward) / pixel_side(camera_);
}

double Sight::skyline_off(const Field<float>& land, const Field<float>& before,
                          double spacing, const std::vector<bool>& counts) const {
    const double pixel = pixel_side(camera_);
    // Within the frame, with a small margin.
    const double half = 1.5 * std::tan(0.5 * camera_.field_of_view);
    const double from = std::max(std::tan(line_.left), -half),
                 to = std::min(std::tan(line_.right), half);
    const int columns = int(std::max(0.0, to - from) / pixel);
    double sum = 0.0;
    int seen = 0;
    for (int c = 0; c < columns; ++c) {
        const double azimuth = std::atan(from + (c + 0.5) * pixel);
        const Ray ray = ray_at(azimuth, 0.0);
        const auto span = over_terrain(land, spacing, eye(), ray.direction);
        if (!span) continue;
        const double share =
            (azimuth - line_.left) / (line_.right - line_.left) * (kValues - 1);
        const double stroke =
            line_.values[std::size_t(std::clamp(share, 0.0, double(kValues - 1)))];
        double skyline = -HUGE_VAL;
        for (double along = std::max((*span)[0], spacing); along < (*span)[1];
             along += kStep * spacing) {
            const Point2 p = on_way(eye(), ray.direction, along);
            const int x = std::clamp(int(p[0] / spacing), 0, land.width() - 1);
            const int y =
                std::clamp(int(land.height() - p[1] / spacing), 0, land.height() - 1);
            const auto rise = [&](const Field<float>& heights) {
                return (height_at(heights, spacing, p) - eye_height()) / along;
            };
            if (counts[land.index(x, y)] && rise(before) <= stroke)
                skyline = std::max(skyline, rise(land));
        }
        if (skyline == -HUGE_VAL) continue;
        sum += std::abs(row_of(azimuth, skyline) - row_of(azimuth, stroke));
        ++seen;
    }
    return seen ? sum / seen : 0.0;
}

std::optional<Landing> landing_of(const Field<float>& land, double spacing,
                                  const Point2& eye, double eye_height,
                                  const Sight::Ray& ray) {
    const auto span = over_terrain(land, spacing, eye, ray.direction);
    if (!span) return {};
    const auto above = [&](double along) {
        return eye_height + ray.rise * along -
               height_at(land, spacing, on_way(eye, ray.direction, along));
    };
    for (double along = (*span)[0]; along < (*span)[1]; along += kStep * spacing) {
        double low = along, high = std::min(along + kStep * spacing, (*span)[1]);
        if (above(high) > 0.0) continue;
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (low + high);
            (above(middle) > 0.0 ? low : high) = middle;
        }
        const Point2 p = on_way(eye, ray.direction, high);
        return Landing{p, height_at(land, spacing, p), false};
    }
    return Landing{on_way(eye, ray.direction, (*span)[1]),
                   eye_height + ray.rise * (*span)[1], true};
}

std::optional<geometry::Shape> part_in_sight(const geometry::Shape& way,
                                             const Sight& sight, double step,
                                             const std::string& name) {
    const int count = std::max(2, int(std::ceil(way.length() / step)));
    std::vector<Point2> best, run;
    for (int i = 0; i <= count; ++i) {
        const Point2 p = way.at(way.length() * i / count);
        if (sight.height_over(p)) run.push_back(p);
        if (run.size() > best.size()) best = run;
        if (!sight.height_over(p)) run.clear();
    }
    if (best.size() < 3) return {};
    return geometry::shape_through(std::move(best), name);
}

}  // namespace cydonia::sketch
