#include "field/svg_document.h"

#include <libxml/parser.h>

#include "field/error.h"
#include "field/files.h"

namespace cydonia {
namespace {

constexpr std::size_t kLargestDrawing = std::size_t{32} << 20;

}  // namespace

SvgDocument::SvgDocument(const Source& source) {
    const std::string text = read_text(source.path, kLargestDrawing);
    // Without the entities of a document type, which can grow without bound.
    document_.reset(
        xmlReadMemory(text.data(), static_cast<int>(text.size()), nullptr, nullptr,
                      XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING));
    root_ = document_ ? xmlDocGetRootElement(document_.get()) : nullptr;
    if (!root_ || name_of(*root_) != "svg")
        throw bad_request("{}: not an SVG drawing", source.path.string());
}

std::string_view name_of(const xmlNode& element) {
    return reinterpret_cast<const char*>(element.name);
}

namespace {

std::string attribute_of(const xmlNode& element, const char* name, const char* space) {
    for (const xmlAttr* a = element.properties; a; a = a->next) {
        const bool same_space =
            space ? a->ns && xmlStrEqual(a->ns->href, BAD_CAST space) : !a->ns;
        if (same_space && xmlStrEqual(a->name, BAD_CAST name) && a->children &&
            a->children->type == XML_TEXT_NODE && a->children->content)
            return reinterpret_cast<const char*>(a->children->content);
    }
    return {};
}

}  // namespace

std::string attribute(const xmlNode& element, const char* name) {
    return attribute_of(element, name, nullptr);
}

std::string label_of(const xmlNode& element) {
    return attribute_of(element, "label", "http://www.inkscape.org/namespaces/inkscape");
}

}  // namespace cydonia
