#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace cydonia::render {

// What a template is filled with: texts, and lists whose parts are repeated.
struct Values {
    std::map<std::string, std::string> texts = {};
    std::map<std::string, std::vector<Values>> lists = {};
};

// A page's template with its holes filled, after Mustache (mustache.github.io):
//   {{name}}               the text, escaped for HTML elements and quoted attributes
//   {{{name}}}             the text as it is: for what is our own
//   {{#name}}...{{/name}}  once for each of the list; once where a text is not empty
//   {{^name}}...{{/name}}  once where there is neither
// Names not found inside a list are looked for around it; unknown ones are empty. Throws
// failure() where a template's parts do not close.
std::string filled(std::string_view text, const Values& values);

}  // namespace cydonia::render
