#include <algorithm>

#include "config/reader/looks.h"
#include "config/reader/readers.h"
#include "field/primaries.h"

namespace cydonia::config {

using render::Material;
using render::Strata;

namespace {

constexpr std::size_t kMostBeds = 32;

// The colour space of a file's colours.
enum class Space { kAcesCg, kRec709 };
constexpr Name<Space> kSpaces[] = {
    {"acescg", Space::kAcesCg},
    {"rec709", Space::kRec709},
};

constexpr Number kShare{from(0.0, 1.0)};

// The range of an albedo: snow reflects nine tenths of the light, coal a fortieth.
Rgb albedo(Rgb colour, Space space) {
    if (space == Space::kAcesCg) colour = rec709_from_acescg(colour);
    for (float& c : colour) c = std::clamp(c, 0.003f, 0.95f);
    return colour;
}

struct StrataTable {
    Strata& strata;
    Space space;
};

void read(Table& t, StrataTable& out) {
    Strata& s = out.strata;
    std::vector<Rgb> colours;
    t.field("colours", colours, kShare);
    t.check(colours.size() <= kMostBeds, {"colours"}, "at most 32 colours are possible");
    for (const Rgb& colour : colours) s.colours.push_back(albedo(colour, out.space));
    t.field("thickness", s.thickness, Number{from(0.5, 1e4)});
    t.field("strength", s.strength, kShare);
    t.field("steeper", s.slope, Degrees{from(0.0, 90.0)});
    t.check(s.slope[0] < s.slope[1], {"steeper"},
            "the first value must be below the second");
}

void read(Table& t, Material& m) {
    Space space = Space::kAcesCg;
    t.field("space", space, one_of(kSpaces));
    t.required("light", m.light, kShare);
    t.required("dark", m.dark, kShare);
    t.field("tint", m.tint, kShare);
    m.light = albedo(m.light, space);
    m.dark = albedo(m.dark, space);
    if (m.tint) m.tint = albedo(*m.tint, space);
    t.field("tinted", m.tinted, kShare);
    t.field("variation", m.variation, Number{from(1.0, 1e5)});
    t.field("grain", m.grain, kShare);
    t.field("bump", m.bump, kShare);
    t.field("bump_size", m.bump_size, Number{from(0.1, 1e4)});
    if (t.has("strata")) {
        StrataTable strata{m.strata.emplace(), space};
        t.table("strata", strata);
    }
    t.only_if(m.tint.has_value(), {"tinted"}, "a material with a tint");
}

}  // namespace

Material read_material(const Source& source) {
    Material material;
    material.name = source.path.stem().string();
    read_data_file(source, [&](Table& t) { read(t, material); });
    return material;
}

}  // namespace cydonia::config
