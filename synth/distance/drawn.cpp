#include <algorithm>
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

// The colours that groups name in a picture; empty when one takes everything drawn.
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

}  // namespace

DrawnStrokes::DrawnStrokes(const Site& site) {
    for (const Group& group : site.options.groups) {
        const auto* strokes = std::get_if<Strokes>(&group.where);
        if (strokes == nullptr) continue;
        const Source& source = strokes->image;
        const auto is_this = [&](const Picture& p) { return same(p.source, source); };
        if (std::ranges::any_of(pictures_, is_this)) continue;

        const Field<Rgba8> cells = read_strokes(source, site.columns, site.rows,
                                                palette_of(site.options, source));
        Picture& picture = pictures_.emplace_back(Picture{source, {}});
        for (std::vector<int>& piece : pieces_of(cells, Rgba8{})) {
            const Rgba8 colour = cells[piece.front()];
            picture.pieces.push_back(
                {colour, stretched(std::move(piece), site.columns, site.rows, site)});
        }
    }
}

std::vector<Shape> DrawnStrokes::of(const Strokes& strokes,
                                    const std::string& group) const {
    const auto picture = std::ranges::find_if(
        pictures_, [&](const Picture& p) { return same(p.source, strokes.image); });
    std::vector<Shape> shapes;
    for (const Piece& piece : picture->pieces) {
        const auto [r, g, b, alpha] = piece.colour;
        // A picture with a palette has its colours exactly.
        if (strokes.colour && *strokes.colour != Colour{r, g, b}) continue;
        shapes.push_back(piece.shape);
    }
    if (shapes.empty()) {
        throw bad_request("group '{}': no stroke of {} has its colour, {}", group,
                          strokes.image.name(), shown(*strokes.colour));
    }
    return shapes;
}

}  // namespace cydonia::distance
