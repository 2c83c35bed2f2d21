#include <algorithm>
#include <bit>
#include <utility>

#include "field/error.h"
#include "field/strokes.h"
#include "synth/distance/sources.h"

namespace cydonia::distance {
namespace {

using Colour = std::array<std::uint8_t, 3>;

bool same(const Source& a, const Source& b) {
    return a.hash == b.hash && a.path == b.path;
}

std::string shown(const Colour& c) {
    return fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]);
}

// The colours that groups name in a picture; empty when a group takes everything that is
// drawn.
std::vector<Colour> palette_of(const Options& options, const Source& source) {
    std::vector<Colour> palette;
    for (const Group& group : options.groups) {
        const auto* strokes = std::get_if<Strokes>(&group.where);
        if (strokes == nullptr || !same(strokes->image, source)) continue;
        if (!strokes->colour) return {};
        palette.push_back(*strokes->colour);
    }
    return palette;
}

// Colours as numbers, which are fast to compare; 0 means that nothing is drawn.
using Colours = Field<std::uint32_t>;

Colours colours_of(const Field<Rgba8>& cells) {
    Colours colours(cells.width(), cells.height());
    std::ranges::transform(cells, colours.begin(), std::bit_cast<std::uint32_t, Rgba8>);
    return colours;
}

Colour colour_of(std::uint32_t number) {
    const auto [r, g, b, alpha] = std::bit_cast<Rgba8>(number);
    return {r, g, b};
}

// The shape to which a cell of the lattice belongs, and its index in that shape's places.
struct Owner {
    int shape = -1;
    int place = 0;
};

// The owner of the nearest cell of this colour among (x, y) and its neighbours; null when
// none has it.
const Owner* owner_near(const Field<Owner>& owners, const Colours& colours, int x, int y,
                        std::uint32_t colour) {
    const auto is = [&](int i, int j) {
        return colours.contains(i, j) && colours(i, j) == colour;
    };
    if (is(x, y)) return &owners(x, y);
    for (const auto [i, j] : {std::array{x - 1, y},
                              {x + 1, y},
                              {x, y - 1},
                              {x, y + 1},
                              {x - 1, y - 1},
                              {x + 1, y - 1},
                              {x - 1, y + 1},
                              {x + 1, y + 1}}) {
        if (is(i, j)) return &owners(i, j);
    }
    return nullptr;
}

// Gives the shapes the land's own cells, when the land is fine enough to show the strokes
// as the lattice does.
void refine(std::vector<Shape*> shapes, const Field<Owner>& owners,
            const Colours& colours, const Colours& fine, const Site& site) {
    const Graph& land = site.graph;
    std::vector<std::vector<SitePoint>> places(shapes.size());
    for (int y = 0; y < land.height; ++y) {
        for (int x = 0; x < land.width; ++x) {
            if (fine(x, y) == 0) continue;
            SitePoint place = site.centre_of(land, land.node(x, y));
            const Owner* owner = owner_near(
                owners, colours, static_cast<int>(place.x / site.width * site.columns),
                static_cast<int>(place.y / site.depth * site.rows), fine(x, y));
            if (owner == nullptr) continue;
            place.root = owner->place;
            places[owner->shape].push_back(place);
        }
    }
    for (std::size_t s = 0; s < shapes.size(); ++s) {
        if (!places[s].empty()) shapes[s]->land = std::move(places[s]);
    }
}

}  // namespace

DrawnStrokes::DrawnStrokes(const Site& site) {
    for (const Group& group : site.options.groups) {
        const auto* strokes = std::get_if<Strokes>(&group.where);
        if (strokes == nullptr) continue;
        const bool known = std::ranges::any_of(pictures_, [&](const Picture& picture) {
            return same(picture.source, strokes->image);
        });
        if (!known)
            pictures_.push_back({strokes->image, components_in(strokes->image, site)});
    }
}

std::vector<DrawnStrokes::Component> DrawnStrokes::components_in(const Source& source,
                                                                 const Site& site) {
    const std::vector<Colour> palette = palette_of(site.options, source);
    const Colours colours =
        colours_of(read_strokes(source, site.columns, site.rows, palette));
    const std::vector<std::vector<int>> found = components_of(colours, 0u);
    std::vector<Component> components;
    Field<Owner> owners(site.columns, site.rows);
    for (const std::vector<int>& cells : found) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            owners[cells[i]] = {static_cast<int>(components.size()), static_cast<int>(i)};
        }
        components.push_back({colour_of(colours[cells.front()]),
                              stretched(cells, site.columns, site.rows, site)});
    }
    if (site.graph.width >= 2 * site.columns) {
        std::vector<Shape*> shapes;
        for (Component& component : components) shapes.push_back(&component.shape);
        const Colours fine = colours_of(
            read_strokes(source, site.graph.width, site.graph.height, palette));
        refine(shapes, owners, colours, fine, site);
    }
    return components;
}

std::vector<Shape> DrawnStrokes::of(const Strokes& strokes,
                                    const std::string& group) const {
    const auto picture = std::ranges::find_if(
        pictures_, [&](const Picture& p) { return same(p.source, strokes.image); });
    std::vector<Shape> shapes;
    for (const Component& component : picture->components) {
        // A picture that was read with a palette has exactly its colours.
        if (strokes.colour && *strokes.colour != component.colour) continue;
        shapes.push_back(component.shape);
    }
    if (shapes.empty()) {
        throw bad_request("group '{}': no stroke of {} has its colour, {}", group,
                          strokes.image.name(), shown(*strokes.colour));
    }
    return shapes;
}

}  // namespace cydonia::distance
