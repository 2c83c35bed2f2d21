#include "field/svg_paths.h"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "field/colour_words.h"
#include "field/error.h"
#include "field/svg.h"
#include "field/svg_document.h"
#include "field/svg_path_data.h"
#include "field/svg_text.h"

namespace cydonia {
namespace {

constexpr std::size_t kMostPoints = 4'000'000;
constexpr double kFarthest = 1e6;  // pages from the page

bool displayed(const xmlNode& element) {
    std::string style = attribute(element, "style");
    std::erase(style, ' ');
    return attribute(element, "display") != "none" &&
           style.find("display:none") == std::string::npos;
}

using Fill = std::optional<std::array<std::uint8_t, 3>>;

// The colour that "#rrggbb", "#rgb", "rgb(r, g, b)" or a basic name means; none for
// anything else.
Fill fill_of(std::string_view text) {
    for (const ColourWord& word : kColourWords)
        if (word.name == text) return word.value;
    const auto hex = [](std::string_view digits) {
        int value = 0;
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
        return error == std::errc() && end == digits.data() + digits.size() ? value : -1;
    };
    std::array<int, 3> rgb{-1, -1, -1};
    if (text.size() == 7 && text[0] == '#') {
        for (std::size_t i = 0; i < 3; ++i) rgb[i] = hex(text.substr(1 + 2 * i, 2));
    } else if (text.size() == 4 && text[0] == '#') {
        for (std::size_t i = 0; i < 3; ++i) rgb[i] = 17 * hex(text.substr(1 + i, 1));
    } else if (text.starts_with("rgb(") && text.ends_with(")")) {
        std::istringstream numbers{std::string(text.substr(4, text.size() - 5))};
        char comma = ',';
        numbers >> rgb[0] >> comma >> rgb[1] >> comma >> rgb[2];
        if (!numbers) return {};
    }
    if (std::ranges::min(rgb) < 0 || std::ranges::max(rgb) > 255) return {};
    return std::array{std::uint8_t(rgb[0]), std::uint8_t(rgb[1]), std::uint8_t(rgb[2])};
}

// The value of an element's own property; its style takes precedence over its attribute.
Fill filled(const xmlNode& element, const Fill& around) {
    std::string style = attribute(element, "style");
    style.insert(style.begin(), ';');
    std::erase(style, ' ');
    std::string text = attribute(element, "fill");
    if (const auto at = style.find(";fill:"); at != style.npos)
        text = style.substr(at + 6, style.find(';', at + 1) - at - 6);
    return text.empty() || text == "inherit" ? around : fill_of(text);
}

// Walks through the drawing and flattens its paths and shapes.
class Walk {
  public:
    Walk(std::array<double, 2> page, double tolerance)
        : page_(page), tolerance_(tolerance) {}

    void enter(const xmlNode& element, Affine to_page, std::string id,
               std::vector<std::string> names, Fill fill);
    std::vector<SvgPath> paths() && { return std::move(paths_); }

  private:
    double length(const xmlNode& element, const char* name, double whole) const;
    double x(const xmlNode& e, const char* name) const {
        return length(e, name, page_[0]);
    }
    double y(const xmlNode& e, const char* name) const {
        return length(e, name, page_[1]);
    }
    std::vector<SvgOutline> outlines(const xmlNode& element) const;
    std::vector<SvgOutline> rectangle(const xmlNode& element) const;
    std::vector<SvgOutline> ellipse(const xmlNode& element) const;
    void add(const SvgOutline& outline, const Affine& to_page, const std::string& id,
             const std::vector<std::string>& names, const Fill& fill);

    std::array<double, 2> page_;  // pixels, or units of its viewBox
    double tolerance_;
    std::vector<SvgPath> paths_;
    std::size_t count_ = 0, shape_ = 0;
};

double Walk::length(const xmlNode& element, const char* name, double whole) const {
    const std::string text = attribute(element, name);
    if (text.empty()) return 0.0;
    const auto value = length_of(text, whole);
    if (!value) throw bad_request("{}='{}' is no length", name, text.substr(0, 40));
    return *value;
}

SvgOutline ring(const Point2& middle, const Point2& r) {
    const Point2 east{middle[0] + r[0], middle[1]}, west{middle[0] - r[0], middle[1]};
    SvgOutline outline{east, {}, true};
    add_arc(outline, r, 0.0, false, true, west);
    add_arc(outline, r, 0.0, false, true, east);
    return outline;
}

std::vector<SvgOutline> Walk::ellipse(const xmlNode& element) const {
    const bool circle = name_of(element) == "circle";
    const Point2 r{x(element, circle ? "r" : "rx"), y(element, circle ? "r" : "ry")};
    if (!(r[0] > 0.0 && r[1] > 0.0)) return {};
    return {ring({x(element, "cx"), y(element, "cy")}, circle ? Point2{r[0], r[0]} : r)};
}

// Rounded corners are ignored: they do not matter for a constraint.
std::vector<SvgOutline> Walk::rectangle(const xmlNode& element) const {
    const double west = x(element, "x"), north = y(element, "y");
    const double east = west + x(element, "width"), south = north + y(element, "height");
    if (!(east > west && south > north)) return {};
    SvgOutline outline{{west, north}, {}, true};
    for (const Point2& corner :
         {Point2{east, north}, {east, south}, {west, south}, {west, north}})
        add_line(outline, corner);
    return {outline};
}

std::vector<SvgOutline> joined(const std::string& points, bool close) {
    NumberReader reader(points);
    std::vector<SvgOutline> outline;
    while (!reader.done()) {
        const auto px = reader.number(), py = reader.number();
        if (!px || !py) throw bad_request("points='{}'", points.substr(0, 40));
        if (outline.empty())
            outline.push_back({{*px, *py}, {}, close});
        else
            add_line(outline[0], {*px, *py});
    }
    if (close && !outline.empty()) add_line(outline[0], outline[0].start);
    return outline;
}

std::vector<SvgOutline> Walk::outlines(const xmlNode& element) const {
    const std::string_view name = name_of(element);
    if (name == "path") return outlines_of(attribute(element, "d"));
    if (name == "circle" || name == "ellipse") return ellipse(element);
    if (name == "rect") return rectangle(element);
    if (name == "polyline" || name == "polygon")
        return joined(attribute(element, "points"), name == "polygon");
    if (name != "line") return {};
    SvgOutline line{{x(element, "x1"), y(element, "y1")}, {}, false};
    add_line(line, {x(element, "x2"), y(element, "y2")});
    return {line};
}

void Walk::add(const SvgOutline& outline, const Affine& to_page, const std::string& id,
               const std::vector<std::string>& names, const Fill& fill) {
    std::vector<Point2> points{to_page(outline.start)};
    for (const auto& curve : outline.curves) {
        const Point2 from = points.back();
        flatten({from, to_page(curve[0]), to_page(curve[1]), to_page(curve[2])},
                tolerance_, points);
        if (points.size() + count_ > kMostPoints)
            throw bad_request("its paths have more than {} points", kMostPoints);
    }
    points.erase(std::unique(points.begin(), points.end()), points.end());
    for (const Point2& p : points)
        if (!(std::abs(p[0]) < kFarthest && std::abs(p[1]) < kFarthest))
            throw bad_request("a path lies more than a million pages away");
    count_ += points.size();
    if (points.size() > 1) paths_.push_back({id, names, std::move(points), fill, shape_});
}

void Walk::enter(const xmlNode& element, Affine to_page, std::string id,
                 std::vector<std::string> names, Fill fill) {
    if (!displayed(element)) return;
    fill = filled(element, fill);
    ++shape_;
    const std::string own = attribute(element, "id"), label = label_of(element);
    if (!own.empty()) id = own;
    for (const std::string& name : {label, own})
        if (!name.empty()) names.insert(names.begin(), name);
    try {
        const auto transform = transform_of(attribute(element, "transform"));
        if (!transform) throw bad_request("its transform cannot be read");
        to_page = to_page * *transform;
        for (const SvgOutline& outline : outlines(element))
            add(outline, to_page, id, names, fill);
    } catch (const Error& error) {
        throw bad_request("line {}{}: {}", element.line, id.empty() ? "" : ", " + id,
                          error.what());
    }
    const std::string_view name = name_of(element);
    if (name != "svg" && name != "g" && name != "a") return;
    // The recursion is bounded because libxml2 refuses elements more than 256 deep.
    for (const xmlNode* child = element.children; child; child = child->next)
        if (child->type == XML_ELEMENT_NODE) enter(*child, to_page, id, names, fill);
}

}  // namespace

bool SvgPath::is_called(const std::string& name) const {
    return std::ranges::find(names, name) != names.end();
}

std::vector<SvgPath> svg_paths(const Source& source, double tolerance) {
    const std::string name = source.path.string();
    const std::array<double, 2> page = page_size(source);
    if (!(page[0] > 0.0))
        throw bad_request(
            "{}: the drawing has no size; give its <svg> a width and height or a viewBox",
            name);
    const SvgDocument document(source);
    const xmlNode& root = document.root();

    const std::string box = attribute(root, "viewBox");
    const auto fitted =
        viewbox_of(box, attribute(root, "preserveAspectRatio"), page[0], page[1]);
    const Affine shares{1.0 / page[0], 0.0, 0.0, 1.0 / page[1], 0.0, 0.0};
    Walk walk(page, tolerance);
    try {
        walk.enter(root, fitted ? shares * *fitted : shares, {}, {}, {});
    } catch (const Error& error) {
        throw bad_request("{}: {}", name, error.what());
    }
    return std::move(walk).paths();
}

}  // namespace cydonia
