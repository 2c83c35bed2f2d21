#include "synth/distance/sides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "field/field.h"

namespace cydonia::distance {
namespace {

using Vector = std::array<float, 2>;
constexpr float kFar = std::numeric_limits<float>::infinity();

Vector unit_vector(double x, double y) {
    const double length = std::hypot(x, y);
    if (!(length > 0.0)) return {0.0f, 0.0f};
    return {static_cast<float>(x / length), static_cast<float>(y / length)};
}

PlaceIndex index_of(const std::vector<Place>& places, const std::vector<int>& part,
                    double reach) {
    PlaceIndex index(reach);
    for (int i : part) index.add(places[i].x, places[i].y, i);
    return index;
}

// Places of a shape and which of them touch.
class Pieces {
  public:
    explicit Pieces(const Shape& shape)
        : shape_(shape), touch_(1.5 * shape.pitch), index_(touch_) {
        for (std::size_t i = 0; i < shape.places.size(); ++i) {
            index_.add(shape.places[i].x, shape.places[i].y, static_cast<int>(i));
        }
    }

    // Metres along the shape from a place; kFar where it does not lead.
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
            const Place& here = shape_.places[at];
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

    // The names of each connected part.
    std::vector<std::vector<int>> parts() const {
        std::vector<std::vector<int>> parts;
        std::vector<bool> seen(shape_.places.size());
        for (std::size_t start = 0; start < seen.size(); ++start) {
            if (seen[start]) continue;
            std::vector<int>& part = parts.emplace_back(1, static_cast<int>(start));
            seen[start] = true;
            for (std::size_t i = 0; i < part.size(); ++i) {
                const Place& here = shape_.places[part[i]];
                index_.within(here.x, here.y, touch_, [&](int name, double) {
                    if (!seen[name]) part.push_back(name);
                    seen[name] = true;
                    return true;
                });
            }
        }
        return parts;
    }

  private:
    const Shape& shape_;
    double touch_;
    PlaceIndex index_;
};

bool is_west_of(const Place& a, const Place& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

// The ground that a part of a shape encloses: the centres of cells of its pitch.
std::vector<Place> enclosed_by(const Shape& shape, const std::vector<int>& part) {
    const double pitch = shape.pitch > 0.0f ? shape.pitch : 1.0;
    double west = kFar, north = kFar, east = -kFar, south = -kFar;
    for (int i : part) {
        const Place& p = shape.places[i];
        west = std::min<double>(west, p.x), east = std::max<double>(east, p.x);
        north = std::min<double>(north, p.y), south = std::max<double>(south, p.y);
    }
    // One free cell all round.
    west -= pitch, north -= pitch;
    enum Cell : char { kUnknown, kDrawn, kOutside };
    Field<Cell> cells(static_cast<int>((east - west) / pitch + 0.5) + 2,
                      static_cast<int>((south - north) / pitch + 0.5) + 2, kUnknown);
    for (int i : part) {
        const Place& p = shape.places[i];
        cells(static_cast<int>((p.x - west) / pitch + 0.5),
              static_cast<int>((p.y - north) / pitch + 0.5)) = kDrawn;
    }
    std::vector<std::array<int, 2>> front{{0, 0}};
    cells(0, 0) = kOutside;
    while (!front.empty()) {
        const auto [x, y] = front.back();
        front.pop_back();
        for (const auto [i, j] :
             {std::array{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}) {
            if (!cells.contains(i, j) || cells(i, j) != kUnknown) continue;
            cells(i, j) = kOutside;
            front.push_back({i, j});
        }
    }
    std::vector<Place> enclosed;
    for (int y = 0; y < cells.height(); ++y) {
        for (int x = 0; x < cells.width(); ++x) {
            if (cells(x, y) != kUnknown) continue;
            enclosed.push_back({static_cast<float>(west + x * pitch),
                                static_cast<float>(north + y * pitch)});
        }
    }
    return enclosed;
}

// A stroke is closed when it goes round something; a few cells that a thick stroke leaves
// out are nothing.
bool goes_round(const std::vector<Place>& enclosed, const std::vector<int>& part) {
    return 4 * enclosed.size() > part.size();
}

bool is_closed(const Shape& shape, const std::vector<int>& part) {
    return shape.centre || goes_round(enclosed_by(shape, part), part);
}

int farthest_of(const std::vector<int>& part, const std::vector<float>& distances) {
    return *std::ranges::max_element(part, {}, [&](int i) { return distances[i]; });
}

// Metres from the beginning of one part.
std::vector<float> distances_along(const Shape& shape, const Pieces& pieces,
                                   const std::vector<int>& part) {
    const auto west_of = [&](int a, int b) {
        return is_west_of(shape.places[a], shape.places[b]);
    };
    if (is_closed(shape, part)) {
        return pieces.distances(*std::ranges::min_element(part, west_of));
    }
    const int one = farthest_of(part, pieces.distances(part.front()));
    const int other = farthest_of(part, pieces.distances(one));
    return pieces.distances(std::min(one, other, west_of));
}

// To the left of where an open part goes on: of the sum of the ways to the places near
// each, counted by how much farther along they are.
void add_left_sides(const Shape& shape, const std::vector<int>& part,
                    const std::vector<float>& along, double reach,
                    std::vector<Vector>& sides) {
    const PlaceIndex index = index_of(shape.places, part, reach);
    for (int i : part) {
        const Place& here = shape.places[i];
        double x = 0.0, y = 0.0;
        index.within(here.x, here.y, reach, [&](int name, double) {
            const double on = along[name] - along[i];
            if (std::abs(on) > 2.0 * reach) return true;  // where the stroke comes back
            x += on * (shape.places[name].x - here.x);
            y += on * (shape.places[name].y - here.y);
            return true;
        });
        // Walking east, the left is north.
        sides[i] = unit_vector(y, -x);
    }
}

// To the middle of what is enclosed nearby.
Vector inward(const Place& here, const PlaceIndex& index,
              const std::vector<Place>& enclosed, const Place& middle, double reach) {
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

Place middle_of(const std::vector<Place>& places) {
    double x = 0.0, y = 0.0;
    for (const Place& p : places) x += p.x, y += p.y;
    const double n = static_cast<double>(places.size());
    return {static_cast<float>(x / n), static_cast<float>(y / n)};
}

}  // namespace

std::vector<float> along(const Shape& shape) {
    std::vector<float> result(shape.places.size());
    if (!(shape.pitch > 0.0f)) return result;
    const Pieces pieces(shape);
    for (const std::vector<int>& part : pieces.parts()) {
        const std::vector<float> distances = distances_along(shape, pieces, part);
        const float whole = distances[farthest_of(part, distances)];
        for (int i : part) result[i] = whole > 0.0f ? distances[i] / whole : 0.0f;
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
    const Pieces pieces(shape);
    for (const std::vector<int>& part : pieces.parts()) {
        const std::vector<Place> enclosed = enclosed_by(shape, part);
        if (!goes_round(enclosed, part)) {
            add_left_sides(shape, part, distances_along(shape, pieces, part), reach,
                           sides);
            continue;
        }
        std::vector<int> all(enclosed.size());
        std::iota(all.begin(), all.end(), 0);
        const PlaceIndex index = index_of(enclosed, all, reach);
        const Place middle = middle_of(enclosed);
        for (int i : part) {
            sides[i] = inward(shape.places[i], index, enclosed, middle, reach);
        }
    }
    return sides;
}

}  // namespace cydonia::distance
