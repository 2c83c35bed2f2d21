#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/gallery/exhibit.h"

namespace cydonia {

// The gallery as one page of HTML, which shows picture files beside it.
std::string page_of(const std::vector<Exhibit>& exhibits);

// The comment that a scene file begins with, without the # signs.
std::string leading_comment(std::string_view scene);

// Text escaped for HTML and SVG, in attributes too.
std::string escaped(std::string_view text);

}  // namespace cydonia
