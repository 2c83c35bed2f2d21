#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/gallery/exhibit.h"

namespace cydonia {

// The gallery as one page of HTML; pictures are links to files beside it.
std::string page_of(const std::vector<Exhibit>& exhibits);

// The comment lines that a scene file begins with, without their marks.
std::string leading_comment(std::string_view scene);

// Text as HTML and SVG may hold it, also in attributes.
std::string escaped(std::string_view text);

}  // namespace cydonia
