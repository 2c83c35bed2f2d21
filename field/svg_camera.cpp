#include "field/svg_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "field/error.h"
#include "field/svg.h"
#include "field/svg_document.h"
#include "field/svg_text.h"

namespace cydonia {
namespace {

constexpr const char* kNamespace = "urn:cydonia";
constexpr double kFarthest = 1e8;  // metres
constexpr int kPixels = 1280;      // across: only the proportions are the page's

const xmlNode* camera_in(const xmlNode& element) {
    for (const xmlNode* child = element.children; child; child = child->next) {
        if (child->type != XML_ELEMENT_NODE) continue;
        if (name_of(*child) == "camera" && child->ns &&
            xmlStrEqual(child->ns->href, BAD_CAST kNamespace))
            return child;
        if (name_of(*child) == "metadata" || name_of(*child) == "g")
            if (const xmlNode* found = camera_in(*child)) return found;
    }
    return nullptr;
}

// Reads exactly so many numbers and nothing else.
template <std::size_t N>
std::optional<std::array<double, N>> numbers(const std::string& text) {
    NumberReader reader(text);
    std::array<double, N> all{};
    for (double& value : all) {
        const auto number = reader.number();
        if (!number || !(std::abs(*number) < kFarthest)) return {};
        value = *number;
    }
    if (!reader.done()) return {};
    return all;
}

}  // namespace

std::string svg_camera_text(const Camera& c) {
    return fmt::format(
        R"(<camera xmlns="{}" eye="{} {} {}" target="{} {} {}" field-of-view="{}"/>)",
        kNamespace, c.eye.x, c.eye.y, c.eye.z, c.target.x, c.target.y, c.target.z,
        degrees(c.field_of_view));
}

std::optional<Camera> svg_camera(const Source& source) {
    const SvgDocument document(source);
    const xmlNode* element = camera_in(document.root());
    if (!element) return {};
    const auto eye = numbers<3>(attribute(*element, "eye")),
               target = numbers<3>(attribute(*element, "target"));
    const auto field = numbers<1>(attribute(*element, "field-of-view"));
    const auto refused = [&](const std::string& why) {
        return bad_request("{}: its camera {}", source.path.string(), why);
    };
    if (!eye || !target)
        throw refused("needs an eye and a target, each of three numbers in metres");
    if (!field || !((*field)[0] >= 1.0 && (*field)[0] <= 170.0))
        throw refused("needs a field-of-view between 1 and 170 degrees");
    Camera camera;
    camera.eye = {(*eye)[0], (*eye)[1], (*eye)[2]};
    camera.target = {(*target)[0], (*target)[1], (*target)[2]};
    camera.field_of_view = radians((*field)[0]);
    const Vec3 view = camera.target - camera.eye;
    if (!(std::hypot(view.x, view.y) > 1e-6 * length(view)))
        throw refused("looks straight up or down");
    const std::array<double, 2> page = page_size(source);
    if (!(page[0] > 0.0 && page[1] > 0.0)) throw refused("has a page without a size");
    camera.width = kPixels;
    camera.height = std::clamp(int(kPixels * page[1] / page[0] + 0.5), 1, 64 * kPixels);
    return camera;
}

}  // namespace cydonia
