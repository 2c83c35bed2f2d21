#pragma once

#include <libxml/tree.h>

#include <memory>
#include <string>
#include <string_view>

#include "field/released.h"
#include "field/source.h"

// An SVG drawing as a tree of elements; included by .cpp files only.
namespace cydonia {

class SvgDocument {
  public:
    // Throws bad_request for what is no drawing.
    explicit SvgDocument(const Source& source);
    const xmlNode& root() const { return *root_; }

  private:
    std::unique_ptr<xmlDoc, Released<xmlFreeDoc>> document_;
    const xmlNode* root_;
};

// The name of an element without its namespace.
std::string_view name_of(const xmlNode& element);
// The value of an attribute without a namespace; empty when the element has none.
std::string attribute(const xmlNode& element, const char* name);
// The label that Inkscape gave the element; empty without one.
std::string label_of(const xmlNode& element);

}  // namespace cydonia
