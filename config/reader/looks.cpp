#include "config/reader/looks.h"

#include <fmt/format.h>

#include <algorithm>

#include "config/reader/parse.h"
#include "config/reader/readers.h"
#include "field/data.h"
#include "field/error.h"
#include "field/files.h"

namespace cydonia::config {

using render::Elevation;
using render::Layer;
using render::Ramp;

namespace {

constexpr std::size_t kMostBytes = 1u << 18;
constexpr std::size_t kMostLayers = 64;

constexpr Name<Layer::Role> kRoles[] = {
    {"none", Layer::Role::kNone},
    {"rock", Layer::Role::kRock},
    {"scree", Layer::Role::kScree},
    {"snow", Layer::Role::kSnow},
};

std::vector<std::string> shipped_names(std::string_view folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(data_folder(folder)))
        if (entry.path().extension() == ".toml")
            names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    return names;
}

// The unit of metres or of a share of the relief, as "40 %".
struct ElevationUnit {
    static constexpr bool kVaries = false;
    Elevation read(const Value& value, Files& files) const {
        if (!std::holds_alternative<std::string>(value.data))
            return {LengthUnit{}.read(value, files).metres, false};
        try {
            return {LengthUnit{}.read(value, files).fraction, true};
        } catch (const Wrong&) {
            throw Wrong{fmt::format(
                "expected metres as a number or a share of the relief such as \"40 %\", "
                "found {}",
                described(value))};
        }
    }
    std::string text(const Elevation& e) const {
        return fmt::format("{}{}", e.value, e.of_relief ? " of the relief" : " m");
    }
    std::string schema() const { return LengthUnit{}.schema(); }
};

struct MaterialName {
    static constexpr bool kVaries = false;
    Source read(const Value& value, Files& files) const {
        return named_file(value, files, "materials", "material");
    }
    std::string text(const Source& source) const { return File{}.text(source); }
    std::string schema() const { return File{}.schema(); }
};

using Pair = std::array<double, 2>;

Ramp ramp_of(const Pair& pair) { return {pair[0], pair[1]}; }

template <class Unit>
void read_ramp(Table& t, std::string_view key, std::optional<Ramp>& ramp,
               const Unit& unit) {
    std::optional<Pair> pair;
    t.field(key, pair, unit);
    if (!pair) return;
    t.check((*pair)[0] != (*pair)[1], {key}, "the two values must differ");
    ramp = ramp_of(*pair);
}

// Reads two rising values. If the ramp `falls`, nothing is left at the second.
void read_steepness(Table& t, std::string_view key, std::optional<Ramp>& ramp,
                    bool falls) {
    read_ramp(t, key, ramp, Degrees{from(0.0, 90.0)});
    if (!ramp) return;
    t.check(ramp->none < ramp->full, {key}, "the first value must be below the second");
    if (falls) std::swap(ramp->none, ramp->full);
}

void read_elevations(Table& t, std::string_view key,
                     std::optional<std::array<Elevation, 2>>& pair, bool falls) {
    t.field(key, pair, ElevationUnit{});
    if (!pair) return;
    const auto& [low, high] = *pair;
    t.check(low.of_relief == high.of_relief, {key},
            "both values must be metres, or both shares of the relief");
    t.check(low.value < high.value, {key}, "the first value must be below the second");
    if (falls) std::swap((*pair)[0], (*pair)[1]);
}

std::size_t index_of(const Source& source, std::vector<Source>& materials) {
    const auto found = std::ranges::find(materials, source.path, &Source::path);
    if (found == materials.end()) materials.push_back(source);
    return static_cast<std::size_t>(
        std::ranges::find(materials, source.path, &Source::path) - materials.begin());
}

}  // namespace

void read(Table& t, Layer& layer, std::vector<Source>& materials) {
    Source material;
    if (t.required("material", material, MaterialName{}))
        layer.material = index_of(material, materials);
    t.field("role", layer.role, one_of(kRoles));
    read_elevations(t, "above", layer.above, false);
    read_elevations(t, "below", layer.below, true);
    read_steepness(t, "steeper", layer.slope, false);
    read_steepness(t, "gentler", layer.gentle, true);
    read_ramp(t, "hollow", layer.hollow, Number{from(-1e4, 1e4)});
    read_ramp(t, "wet", layer.wet, Number{from(-20.0, 40.0)});
    read_ramp(t, "north", layer.north, Number{from(-2.0, 2.0)});
    t.field("mask", layer.mask, Text{});
    t.field("patches", layer.patches, Number{from(0.0, 1.0)});
    t.field("patch_size", layer.patch_size, Number{from(1.0, 1e5)});
    t.field("north_lowers", layer.north_lowers, Number{from(-1e4, 1e4)});
    t.field("hollow_lowers", layer.hollow_lowers, Number{from(-1e3, 1e3)});
    t.field("soft", layer.soft, Number{from(0.0, 1.0)});
    t.field("amount", layer.amount, Number{from(0.0, 1.0)});
    t.only_if(layer.patches < 1.0, {"patch_size"}, "patches below 1");
    t.only_if(layer.above.has_value() || layer.role == Layer::Role::kSnow,
              {"north_lowers", "hollow_lowers"}, "a layer with above");
}

namespace {

// Reads the material of a shore, which no layer has.
void read_beside(Table& t, std::string_view key, std::optional<std::size_t>& out,
                 std::vector<Source>& materials) {
    std::optional<Source> material;
    t.field(key, material, MaterialName{});
    if (material) out = index_of(*material, materials);
}

void read(Table& t, LookFile& out) {
    t.field("exposure", out.exposure, Number{from(-20.0, 20.0)});
    t.table("sky", out.sky);
    t.table("haze", out.haze);
    t.table("fine_relief", out.fine_relief);
    t.tables("layer", out.look.layers, kMostLayers, out.materials);
    t.check(t.has("layer") && !out.look.layers.empty() && !out.look.layers[0].limited(),
            {"layer"},
            "a look needs a first [[layer]] without conditions, which lies everywhere");
    read_beside(t, "shore", out.look.shore, out.materials);
    read_beside(t, "bed", out.look.bed, out.materials);
    t.only_if(out.look.shore.has_value(), {"bed"}, "a look with a shore");
}

}  // namespace

void read_data_file(const Source& source, const std::function<void(Table&)>& read) {
    const std::string file = source.path.string();
    const Value root = parse(read_text(source.path, kMostBytes), file);
    Files files(source.path.parent_path());
    Reading reading{files};
    Table table(reading, &root, root.at);
    read(table);
    table.report_unknown();
    if (!reading.mistakes.empty())
        throw bad_request("{}", listed(std::move(reading.mistakes), {file, {}}));
}

Source named_file(const Value& value, Files& files, std::string_view folder,
                  std::string_view what) {
    const std::string name = Text{4096}.read(value, files);
    if (name.ends_with(".toml")) return files.open(name);
    const auto known = shipped_names(folder);
    if (std::ranges::find(known, name) == known.end())
        throw Wrong{fmt::format("no {} '{}'{}", what, name, suggestion(name, known))};
    return open_source(data_file(fmt::format("{}/{}.toml", folder, name)));
}

Source LookName::read(const Value& value, Files& files) const {
    return named_file(value, files, "looks", "look");
}

Source default_look() { return open_source(data_file("looks/natural.toml")); }

LookFile read_look(const Source& source) {
    LookFile out;
    out.look.name = source.path.stem().string();
    read_data_file(source, [&](Table& t) { read(t, out); });
    out.look.materials.clear();
    for (const Source& material : out.materials)
        out.look.materials.push_back(read_material(material));
    return out;
}

}  // namespace cydonia::config
