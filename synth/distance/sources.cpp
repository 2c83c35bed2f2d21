// B. Rusnell, "Distance-based terrain synthesis" (2009), sections 4.1, 4.2.5 and 4.3.1.

#include "synth/distance/sources.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "field/error.h"
#include "field/noise.h"
#include "field/random.h"
#include "field/strokes.h"
#include "field/svg.h"

namespace cydonia::distance {
namespace {

// The samples [first, last) of one axis whose centres a cell covers. Where cells are
// smaller than samples, it is the one sample that holds the cell's centre.
std::array<int, 2> samples_of(int cell, int cells, int samples) {
    const auto first = [&](std::int64_t c) {
        return static_cast<int>((2 * c * samples + cells - 1) / (2 * cells));
    };
    if (first(cell) < first(cell + 1)) return {first(cell), first(cell + 1)};
    const int holding =
        static_cast<int>((2 * std::int64_t{cell} + 1) * samples / (2 * cells));
    return {holding, holding + 1};
}

// A value in [-1, 1] that repeats after a full turn.
double round_noise(double angle, std::uint64_t seed) {
    const double x = std::cos(angle), y = std::sin(angle);
    const double sum = gradient_noise(1.5 * x, 1.5 * y, seed) +
                       0.5 * gradient_noise(3.0 * x, 3.0 * y, mix(seed)) +
                       0.25 * gradient_noise(6.0 * x, 6.0 * y, mix(seed + 1));
    return std::clamp(sum, -1.0, 1.0);
}

struct Rim {
    SitePoint centre;
    double radius;
    double roughness;
    std::uint64_t seed;

    double radius_at(double angle) const {
        return radius * (1.0 + roughness * round_noise(angle, seed));
    }
    SitePoint at(double angle) const {
        const double r = radius_at(angle);
        return {static_cast<float>(centre.x + r * std::cos(angle)),
                static_cast<float>(centre.y + r * std::sin(angle))};
    }
    bool encloses(const SitePoint& place) const {
        const double dx = place.x - centre.x, dy = place.y - centre.y;
        return std::hypot(dx, dy) < radius_at(std::atan2(dy, dx));
    }
};

// A smaller circle is a younger one and erases the rims that were there.
bool erased(const SitePoint& place, const Rim& rim, const std::vector<Rim>& rims) {
    return std::ranges::any_of(rims, [&](const Rim& other) {
        return other.radius < rim.radius && other.encloses(place);
    });
}

Shape rim_shape(const Rim& rim, const std::vector<Rim>& rims, const Site& site) {
    const auto shows = [&](const SitePoint& place) {
        return site.contains(place.x, place.y) && !erased(place, rim, rims);
    };
    Shape shape;
    shape.pitch = static_cast<float>(std::max(site.width, site.depth) / 1024.0);
    shape.centre = {{rim.centre.x, rim.centre.y}};
    const int count =
        std::max(24, static_cast<int>(std::ceil(4.0 * std::numbers::pi * rim.radius *
                                                (1.0 + rim.roughness) / shape.pitch)));
    std::vector<SitePoint> line;
    SitePoint before = rim.at(0.0);
    for (int i = 1; i <= count; ++i) {
        SitePoint here = rim.at(2.0 * std::numbers::pi * (i % count) / count);
        here.root = static_cast<int>(shape.places.size());
        if (shows(here)) {
            shape.places.push_back(here);
        } else {
            here.root = std::max(0, here.root - 1);
        }
        append_line(line, before, here, site.graph.spacing);
        before = here;
    }
    // Where the curve enters the land there is no place before.
    for (SitePoint& place : line) {
        if (shape.places.empty() || !shows(place)) continue;
        place.root = std::min(place.root, static_cast<int>(shape.places.size()) - 1);
        shape.land.push_back(place);
    }
    return shape;
}

void check(const Circles& circles, const std::string& group, const Site& site) {
    const double low = circles.radius[0].in(site.width);
    const double high = circles.radius[1].in(site.width);
    if (!(low > 0.0 && low <= high)) {
        throw bad_request(
            "group '{}': radius is from {} m to {} m: it must be above 0 and rise", group,
            low, high);
    }
    if (!(circles.roughness >= 0.0 && circles.roughness < 1.0)) {
        throw bad_request(
            "group '{}': roughness is {}: it must be at least 0 and below 1", group,
            circles.roughness);
    }
    // With this radius some of the rim lies on the land wherever its centre is.
    const double most =
        0.5 * std::hypot(site.width, site.depth) / (1.0 + circles.roughness);
    if (high > most) {
        throw bad_request("group '{}': radius is up to {} m: it must be at most {:.0f} m",
                          group, high, most);
    }
}

}  // namespace

Shape stretched(const std::vector<int>& cells, int columns, int rows, const Site& site) {
    const double across = site.width / columns, down = site.depth / rows;
    Shape shape;
    shape.pitch = static_cast<float>(std::max(across, down));
    for (int cell : cells) {
        const int column = cell % columns, row = cell / columns;
        const int root = static_cast<int>(shape.places.size());
        shape.places.push_back({static_cast<float>((column + 0.5) * across),
                                static_cast<float>((row + 0.5) * down), 0.0f, root});
        const auto [west, east] = samples_of(column, columns, site.graph.width);
        const auto [north, south] = samples_of(row, rows, site.graph.height);
        for (int y = north; y < south; ++y) {
            for (int x = west; x < east; ++x) {
                SitePoint place = site.centre_of(site.graph, site.graph.node(x, y));
                place.root = root;
                const bool again = !shape.land.empty() &&
                                   shape.land.back().x == place.x &&
                                   shape.land.back().y == place.y;
                if (!again) shape.land.push_back(place);
            }
        }
    }
    return shape;
}

std::vector<Shape> peak_shapes(const Peaks& peaks, const std::string& group,
                               const Site& site, const std::vector<PlacedGroup>& before) {
    std::vector<Shape> shapes;
    for (const SitePoint& place : random_places(peaks.placement, group, site, before)) {
        Shape& shape = shapes.emplace_back();
        shape.places = shape.land = {place};
    }
    return shapes;
}

std::vector<Shape> circle_shapes(const Circles& circles, const std::string& group,
                                 const Site& site,
                                 const std::vector<PlacedGroup>& before) {
    check(circles, group, site);
    const double low = circles.radius[0].in(site.width);
    const double high = circles.radius[1].in(site.width);
    std::vector<Rim> rims;
    for (const SitePoint& centre :
         random_places(circles.placement, group, site, before)) {
        const std::uint64_t h =
            hash_of({site.seed, key("radius"), key_of(group), rims.size()});
        rims.push_back(
            {centre, std::lerp(low, high, unit(h)), circles.roughness, mix(h)});
    }
    std::vector<Shape> shapes;
    for (const Rim& rim : rims) {
        Shape shape = rim_shape(rim, rims, site);
        if (!shape.land.empty()) shapes.push_back(std::move(shape));
    }
    return shapes;
}

std::vector<Shape> edge_shapes(const Edges& edges, const std::string& group,
                               const Site& site) {
    if (!(edges.threshold > 0.0 && edges.threshold <= 1.0)) {
        throw bad_request("group '{}': threshold is {}: it must be above 0, at most 1",
                          group, edges.threshold);
    }
    Field<float> grey = is_svg(edges.image)
                            ? read_grey_at(edges.image, site.columns, site.rows)
                            : read_grey(edges.image);
    const cv::Mat image(grey.height(), grey.width(), CV_32F, grey.data());
    cv::Mat across, down, gradient;
    cv::Sobel(image, across, CV_32F, 1, 0, 3, 1, 0, cv::BORDER_REPLICATE);
    cv::Sobel(image, down, CV_32F, 0, 1, 3, 1, 0, cv::BORDER_REPLICATE);
    cv::magnitude(across, down, gradient);
    double least = 0.0, greatest = 0.0;
    cv::minMaxLoc(gradient, &least, &greatest);
    if (!(greatest > least)) {
        throw bad_request("group '{}': {} has no edges", group, edges.image.name());
    }
    // Rusnell 2009, eq. 4.3
    const double threshold = least + edges.threshold * (greatest - least);
    Field<std::uint8_t> found(grey.width(), grey.height());
    for (int y = 0; y < grey.height(); ++y) {
        for (int x = 0; x < grey.width(); ++x) {
            found(x, y) = gradient.at<float>(y, x) >= threshold ? 1 : 0;
        }
    }
    std::vector<Shape> shapes;
    for (const std::vector<int>& component : components_of(found, std::uint8_t{0})) {
        shapes.push_back(stretched(component, grey.width(), grey.height(), site));
    }
    return shapes;
}

}  // namespace cydonia::distance
