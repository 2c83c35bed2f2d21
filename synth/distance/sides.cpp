#include "synth/distance/sides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "field/enclosed.h"

namespace cydonia::distance {
namespace {

using Vector = std::array<float, 2>;
constexpr float kFar = std::numeric_limits<float>::infinity();

Vector unit_vector(double x, double y) {
    const double length = std::hypot(x, y);
    if (!(length > 0.0)) return {0.0f, 0.0f};
    return {static_cast<float>(x / length), static_cast<float>(y / length)};
}

PointIndex index_of(const std::vector<SitePoint>& places,
                    const std::vector<int>& component, double reach) {
    PointIndex index(reach);
    for (int i : component) index.add(places[i].x, places[i].y, i);
    return index;
}

// The connected components of a shape's places, which are connected when they touch.
class Components {
  public:
    explicit Components(const Shape& shape)
        : shape_(shape), touch_(1.5 * shape.pitch), index_(touch_) {
        for (std::size_t i = 0; i < shape.places.size(); ++i) {
            index_.add(shape.places[i].x, shape.places[i].y, static_cast<int>(i));
        }
    }

    // The distances in metres along the shape from a place; kFar for places that are not
    // connected with it.
    std::vector<float> distances(int from) const {
        std::vector<float> distances(shape_.places.size(), kFar);
        using Entry = std::pair<float, int>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
        distances[from] = 0.0f;
        front.push({0.0f, from});
        while (!front.empty()) {
            const auto [distance, at] = front.top();
            front.pop();
            if (distance > distances[at]) continue;
            const SitePoint& here = shape_.places[at];
            index_.within(here.x, here.y, touch_, [&](int name, double square) {
                const float there = distance + static_cast<float>(std::sqrt(square));
                if (there < distances[name]) {
                    distances[name] = there;
                    front.push({there, name});
                }
                return true;
            });
        }
        return distances;
    }

    // The indices of the places of each component.
    std::vector<std::vector<int>> members() const {
        std::vector<std::vector<int>> members;
        std::vector<bool> seen(shape_.places.size());
        for (std::size_t start = 0; start < seen.size(); ++start) {
            if (seen[start]) continue;
            std::vector<int>& component =
                members.emplace_back(1, static_cast<int>(start));
            seen[start] = true;
            for (std::size_t i = 0; i < component.size(); ++i) {
                const SitePoint& here = shape_.places[component[i]];
                index_.within(here.x, here.y, touch_, [&](int name, double) {
                    if (!seen[name]) component.push_back(name);
                    seen[name] = true;
                    return true;
                });
            }
        }
        return members;
    }

  private:
    const Shape& shape_;
    double touch_;
    PointIndex index_;
};

bool is_west_of(const SitePoint& a, const SitePoint& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

// The ground that a component of a shape encloses, as the centres of cells that are as
// large as its pitch.
std::vector<SitePoint> ground_within(const Shape& shape,
                                     const std::vector<int>& component) {
    const double pitch = shape.pitch > 0.0f ? shape.pitch : 1.0;
    double west = kFar, north = kFar, east = -kFar, south = -kFar;
    for (int i : component) {
        const SitePoint& p = shape.places[i];
        west = std::min<double>(west, p.x), east = std::max<double>(east, p.x);
        north = std::min<double>(north, p.y), south = std::max<double>(south, p.y);
    }
    west -= pitch, north -= pitch;
    Field<std::uint8_t> drawn(static_cast<int>((east - west) / pitch + 0.5) + 2,
                              static_cast<int>((south - north) / pitch + 0.5) + 2);
    for (int i : component) {
        const SitePoint& p = shape.places[i];
        drawn(static_cast<int>((p.x - west) / pitch + 0.5),
              static_cast<int>((p.y - north) / pitch + 0.5)) = 1;
    }
    const Field<std::uint8_t> mask = enclosed_by(drawn);
    std::vector<SitePoint> enclosed;
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
            if (mask(x, y) == 0) continue;
            enclosed.push_back({static_cast<float>(west + x * pitch),
                                static_cast<float>(north + y * pitch)});
        }
    }
    return enclosed;
}

// A stroke is closed when it goes round something. A few cells that a thick stroke leaves
// out do not count.
bool goes_round(const std::vector<SitePoint>& enclosed,
                const std::vector<int>& component) {
    return 4 * enclosed.size() > component.size();
}

bool is_closed(const Shape& shape, const std::vector<int>& component) {
    return shape.centre || goes_round(ground_within(shape, component), component);
}

int farthest_of(const std::vector<int>& component, const std::vector<float>& distances) {
    return *std::ranges::max_element(component, {}, [&](int i) { return distances[i]; });
}

// The distances in metres from the beginning of a component.
std::vector<float> distances_along(const Shape& shape, const Components& components,
                                   const std::vector<int>& component) {
    const auto west_of = [&](int a, int b) {
        return is_west_of(shape.places[a], shape.places[b]);
    };
    if (is_closed(shape, component)) {
        return components.distances(*std::ranges::min_element(component, west_of));
    }
    const int one = farthest_of(component, components.distances(component.front()));
    const int other = farthest_of(component, components.distances(one));
    return components.distances(std::min(one, other, west_of));
}

// The left side of an open component at each of its places. The direction there is the
// sum of the vectors to the places nearby, weighted by how much farther along the stroke
// they are.
void add_left_sides(const Shape& shape, const std::vector<int>& component,
                    const std::vector<float>& along, double reach,
                    std::vector<Vector>& sides) {
    const PointIndex index = index_of(shape.places, component, reach);
    for (int i : component) {
        const SitePoint& here = shape.places[i];
        double x = 0.0, y = 0.0;
        index.within(here.x, here.y, reach, [&](int name, double) {
            const double on = along[name] - along[i];
            if (std::abs(on) > 2.0 * reach) return true;  // the stroke comes back here
            x += on * (shape.places[name].x - here.x);
            y += on * (shape.places[name].y - here.y);
            return true;
        });
        // When the stroke runs east, its left is north.
        sides[i] = unit_vector(y, -x);
    }
}

// The unit vector to the middle of the enclosed ground nearby.
Vector inward(const SitePoint& here, const PointIndex& index,
              const std::vector<SitePoint>& enclosed, const SitePoint& middle,
              double reach) {
    double x = 0.0, y = 0.0;
    index.within(here.x, here.y, reach, [&](int name, double) {
        x += enclosed[name].x - here.x;
        y += enclosed[name].y - here.y;
        return true;
    });
    const Vector side = unit_vector(x, y);
    if (side != Vector{}) return side;
    return unit_vector(middle.x - here.x, middle.y - here.y);
}

SitePoint middle_of(const std::vector<SitePoint>& places) {
    double x = 0.0, y = 0.0;
    for (const SitePoint& p : places) x += p.x, y += p.y;
    const double n = static_cast<double>(places.size());
    return {static_cast<float>(x / n), static_cast<float>(y / n)};
}

}  // namespace

std::vector<float> along(const Shape& shape) {
    std::vector<float> result(shape.places.size());
    if (!(shape.pitch > 0.0f)) return result;
    const Components components(shape);
    for (const std::vector<int>& component : components.members()) {
        const std::vector<float> distances =
            distances_along(shape, components, component);
        const float whole = distances[farthest_of(component, distances)];
        for (int i : component) result[i] = whole > 0.0f ? distances[i] / whole : 0.0f;
    }
    return result;
}

std::vector<Vector> left_sides(const Shape& shape, double reach) {
    std::vector<Vector> sides(shape.places.size());
    if (shape.centre) {
        const auto [x, y] = *shape.centre;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            sides[i] = unit_vector(x - shape.places[i].x, y - shape.places[i].y);
        }
        return sides;
    }
    const Components components(shape);
    for (const std::vector<int>& component : components.members()) {
        const std::vector<SitePoint> enclosed = ground_within(shape, component);
        if (!goes_round(enclosed, component)) {
            add_left_sides(shape, component,
                           distances_along(shape, components, component), reach, sides);
            continue;
        }
        std::vector<int> all(enclosed.size());
        std::iota(all.begin(), all.end(), 0);
        const PointIndex index = index_of(enclosed, all, reach);
        const SitePoint middle = middle_of(enclosed);
        for (int i : component) {
            sides[i] = inward(shape.places[i], index, enclosed, middle, reach);
        }
    }
    return sides;
}

}  // namespace cydonia::distance
