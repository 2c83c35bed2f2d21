#pragma once

#include <array>
#include <string>

#include "field/field.h"
#include "field/image.h"
#include "field/source.h"

namespace cydonia {

// By the file's first character, '<': images and SVG are told apart by what they hold.
bool is_svg(const Source& source);

// kCrisp: no pixel between two colours, every pixel drawn or not. kSmooth: antialiased.
enum class SvgEdges { kCrisp, kSmooth };

// The drawing stretched to width x height pixels, transparent where nothing is drawn, not
// premultiplied. Files it refers to are not opened. Throws bad_request.
Field<Rgba8> read_svg(const Source& source, int width, int height, SvgEdges edges);
// The same of a drawing's text; messages call it `name`.
Field<Rgba8> drawn_svg(const std::string& name, const std::string& text, int width,
                       int height, SvgEdges edges);

// Width and height of the drawing's own page; {0, 0} when it gives none. Throws
// bad_request.
std::array<double, 2> page_size(const Source& source);

}  // namespace cydonia
