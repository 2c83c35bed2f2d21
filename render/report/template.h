#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace cydonia::render {

// The values for a template: texts, and lists whose part is repeated for each item.
struct Values {
    std::map<std::string, std::string> texts = {};
    std::map<std::string, std::vector<Values>> lists = {};
};

// Fills a template in the manner of Mustache (mustache.github.io):
//   {{name}}               the text, escaped for HTML elements and quoted attributes
//   {{{name}}}             the text unescaped, for text of our own
//   {{#name}}...{{/name}}  once for each item of the list, or once if the text is not
//   empty
//   {{^name}}...{{/name}}  once if there is neither
// A name that an item lacks is looked up in the scopes around it; an unknown name is
// empty. Throws failure() when a part is not closed.
std::string filled(std::string_view text, const Values& values);

}  // namespace cydonia::render
