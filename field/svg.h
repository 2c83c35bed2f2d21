#pragma once

#include <array>
#include <string>

#include "field/field.h"
#include "field/image.h"
#include "field/source.h"

namespace cydonia {

// Whether a file is an SVG drawing, by its first character '<'. The extension does not
// matter.
bool is_svg(const Source& source);

// kCrisp: every pixel has a colour of the drawing or is not drawn at all. kSmooth:
// antialiased.
enum class SvgEdges { kCrisp, kSmooth };

// Draws an SVG stretched to width x height pixels: transparent where nothing is drawn,
// not premultiplied. Files that it refers to are not opened. Throws bad_request for what
// is no drawing.
Field<Rgba8> read_svg(const Source& source, int width, int height, SvgEdges edges);
// The same for the text of a drawing, which messages call `name`.
Field<Rgba8> drawn_svg(const std::string& name, const std::string& text, int width,
                       int height, SvgEdges edges);

// The width and height of the drawing's own page; {0, 0} when it gives none. Throws
// bad_request for what is no drawing.
std::array<double, 2> page_size(const Source& source);

}  // namespace cydonia
