// Things on the ground: many copies of a few originals, in metres; the union is scaled.
#include "render/pov/things.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <array>
#include <cctype>
#include <iterator>
#include <utility>

#include "render/pov/pieces.h"
#include "render/scene/things.h"
#include "render/things/originals.h"

namespace cydonia::render::pov {
namespace {

// "Conifer": what the .pov calls the originals of a kind, before their number.
std::string declared_name(ThingOptions::Kind kind) {
    std::string name(name_in(kThingKinds, kind));
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return name;
}

std::string vector(const std::array<float, 3>& v) {
    return fmt::format("<{:.4g},{:.4g},{:.4g}>", v[0], v[2], v[1]);
}

template <class Vectors>
void list(std::string& text, const char* what, const Vectors& vectors) {
    text += fmt::format("    {} {{ {}", what, vectors.size());
    for (const auto& v : vectors) text.append(",").append(vector(v));
    text += " }\n";
}

std::string mesh(const Original::Part& part) {
    std::string text = "mesh2 {\n";
    list(text, "vertex_vectors", part.vertices);
    if (part.smooth) list(text, "normal_vectors", normals_of(part));
    text += fmt::format("    face_indices {{ {}", part.triangles.size());
    for (const auto& [a, b, c] : part.triangles)
        text += fmt::format(",<{},{},{}>", a, b, c);
    return text + fmt::format(
                      " }}\n    texture {{ pigment {{ color rgb <{}> }} "
                      "finish {{ ThingFinish }} }}\n}}\n",
                      numbers(part.albedo));
}

std::string original(ThingOptions::Kind kind, int number) {
    const Original of = original_of(kind, number);
    std::string text =
        fmt::format("#declare {}{} = union {{\n", declared_name(kind), number);
    for (const Original::Part& part : of.parts) text += mesh(part);
    return text + "}\n";
}

}  // namespace

std::string things(const Shot& shot, const Terrain& terrain) {
    const std::vector<ThingOptions>& kinds = shot.options.things;
    if (kinds.empty()) return "";
    // Light through leaves and between blades is not traced; a share of the sky's light
    // stands for it.
    std::string text = R"(// Things on the ground: x east, y up, z north, metres.
#declare ThingFinish = finish { diffuse 0.9, 0.25 emission 0.25 * SkyLight * SkyFill }
)";
    std::array<bool, std::size(kThingKinds)> declared{};
    std::string copies;
    const std::vector<std::vector<Thing>> strewn = things_of(shot, terrain);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const ThingOptions& of = kinds[i];
        const std::string name = declared_name(of.kind);
        for (const Thing& thing : strewn[i])
            fmt::format_to(std::back_inserter(copies),
                           "object{{{}{} scale {:.4g} rotate {:.1f}*y "
                           "translate<{:.7g},{:.7g},{:.7g}>}}\n",
                           name, thing.original, thing.height, degrees(thing.turn),
                           thing.foot.x, thing.foot.z, thing.foot.y);
        if (strewn[i].empty() || std::exchange(declared[std::size_t(of.kind)], true))
            continue;
        for (int k = 0; k < kOriginals; ++k) text += original(of.kind, k);
    }
    if (copies.empty()) return "";
    return text + "union {\n" + copies + "    scale 1 / Unit\n}\n";
}

}  // namespace cydonia::render::pov
