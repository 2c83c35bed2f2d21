#pragma once

#include <string>
#include <vector>

#include "field/field.h"
#include "synth/distance/places.h"
#include "synth/distance/site.h"

namespace cydonia::distance {

// F, Rusnell 2009, section 3.2: where the features of a group are. All functions throw
// bad_request, naming the group, for numbers out of range and when they find nothing.

// The strokes of all pictures that groups name. Each picture is read once.
class DrawnStrokes {
  public:
    // Throws bad_request for a drawn colour that no group has, when the groups of a
    // picture have colours.
    explicit DrawnStrokes(const Site& site);

    // Connected components of one colour, in reading order.
    std::vector<Shape> of(const Strokes& strokes, const std::string& group) const;

  private:
    struct Component {
        std::array<std::uint8_t, 3> colour;
        Shape shape;
    };
    static std::vector<Component> components_in(const Source& source, const Site& site);

    struct Picture {
        Source source;
        std::vector<Component> components;
    };
    std::vector<Picture> pictures_;
};

std::vector<Shape> peak_shapes(const Peaks& peaks, const std::string& group,
                               const Site& site, const std::vector<PlacedGroup>& before);

// Closed curves. What leaves the land is cut off, and so are rims that a smaller circle
// covers.
std::vector<Shape> circle_shapes(const Circles& circles, const std::string& group,
                                 const Site& site,
                                 const std::vector<PlacedGroup>& before);

// Connected components of the picture's own pixels with a gradient above eq. 4.3's.
std::vector<Shape> edge_shapes(const Edges& edges, const std::string& group,
                               const Site& site);

// One feature for each level, with its cost.
std::vector<Shape> terrace_shapes(const Terraces& terraces, const std::string& group,
                                  const Site& site);

// One feature: the nodes within the distance that have a neighbour beyond it.
std::vector<Shape> lip_shape(const Lip& lip, const std::string& group, const Site& site);

// The cells of each connected component of equal values. Components and cells are in
// reading order. Cells that equal `nothing` belong to none, and corners connect. (OpenCV
// labels the components of a single value only.)
template <class T>
std::vector<std::vector<int>> components_of(const Field<T>& cells, const T& nothing) {
    std::vector<std::vector<int>> components;
    std::vector<int> front;
    Field<int> component_of(cells.width(), cells.height(), -1);
    for (int start = 0; start < static_cast<int>(cells.size()); ++start) {
        if (cells[start] == nothing) continue;
        if (component_of[start] < 0) {
            component_of[start] = static_cast<int>(components.size());
            components.emplace_back();
            front.push_back(start);
        }
        while (!front.empty()) {
            const int cell = front.back();
            front.pop_back();
            const int x0 = cell % cells.width(), y0 = cell / cells.width();
            for (int y = y0 - 1; y <= y0 + 1; ++y) {
                for (int x = x0 - 1; x <= x0 + 1; ++x) {
                    if (!cells.contains(x, y) || cells(x, y) != cells[start]) continue;
                    if (component_of(x, y) >= 0) continue;
                    component_of(x, y) = component_of[start];
                    front.push_back(y * cells.width() + x);
                }
            }
        }
        components[component_of[start]].push_back(start);
    }
    return components;
}

// The shape of some cells of a columns x rows picture that is stretched over the land.
Shape stretched(const std::vector<int>& cells, int columns, int rows, const Site& site);

}  // namespace cydonia::distance
