#include "config/reader/texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "config/reader/readers.h"

namespace cydonia::config {

using texture::Exemplar;
using texture::Options;
using texture::Type;

namespace {

constexpr std::size_t kMostTypes = 32;  // bits of texture::TypeSet
constexpr std::size_t kMostShapes = 1024, kMostPastes = 256;
constexpr Range kScales = above_to(0.0, 1000.0);

// The unit of the name of a type of the stage.
struct TypeName {
    const std::vector<std::string>& known;
    static constexpr bool kVaries = false;
    std::string read(const Value& value, Files&) const {
        return known[named(value, known)];
    }
    std::string text(const std::string& name) const { return name; }
    std::string schema() const { return Word{}.schema(); }
};

bool is_white(const Colour::Rgb& rgb) { return std::ranges::min(rgb) >= 250; }

}  // namespace

void read_name(Table& t, std::string& name, std::string_view kind, std::size_t number,
               std::vector<std::string>& taken) {
    constexpr std::size_t kLongest = 64;
    name = fmt::format("{} {}", kind, number);
    t.field("name", name, Text{kLongest});
    t.check(std::ranges::find(taken, name) == taken.end(), {"name"},
            fmt::format("'{}' is taken by another one", name));
    taken.push_back(name);
}

void read(Table& t, Type& type, const std::vector<Type>& all) {
    t.required("name", type.name, Word{});
    t.required("colour", type.colour, Colour{});
    t.check(!is_white(type.colour), {"colour"},
            "white stands for land of any type; choose another colour");
    const auto like = [&](const Type& other) {
        return &other < &type && other.colour == type.colour;
    };
    const auto other = std::ranges::find_if(all, like);
    if (other != all.end())
        t.check(false, {"colour"},
                fmt::format("'{}' has this colour already", other->name));
}

void read(Table& t, Exemplar& exemplar, const TextureNames& names) {
    t.required("source", exemplar.source, ElevationModel{});
    t.field("types", exemplar.types, File{});
    t.field("type", exemplar.type, TypeName{names.types});
    t.check(!exemplar.types || exemplar.type.empty(), {"type", "types"},
            "give one type for the whole model or a picture of types, not both");
    t.only_if(!names.types.empty(), {"type", "types"},
              "a stage with [[terrain.stage.type]]");
}

namespace {

void read_exemplars(Table& t, Options& o, TextureNames& names) {
    std::vector<std::vector<Source>> found;
    t.field("exemplars", found, OneOrMore{ElevationModels{}});
    for (const auto& sources : found)
        for (const Source& source : sources) o.exemplars.push_back({source, {}, {}});
    std::vector<Exemplar> more;
    t.tables("exemplar", more, kMostExemplars, names);
    std::ranges::move(more, std::back_inserter(o.exemplars));

    for (const Exemplar& exemplar : o.exemplars)
        names.exemplars.push_back(exemplar.source.path.stem().string());
    t.check(!o.exemplars.empty(), {"exemplars", "exemplar"},
            "there are no exemplars to make land from; name elevation models, or "
            "\"package:jacksboro\" to begin with");
    t.check(o.exemplars.size() <= kMostExemplars, {"exemplars", "exemplar"},
            fmt::format("{} elevation models are too many; at most {}",
                        o.exemplars.size(), kMostExemplars));
}

void read_types(Table& t, Options& o, TextureNames& names) {
    t.tables("type", o.types, kMostTypes, o.types);
    t.unique("type", "name");
    for (const Type& type : o.types) names.types.push_back(type.name);
}

void read_painting(Table& t, Options& o) {
    t.field("automatic_types", o.automatic_types, Flag{});
    t.field("paint", o.paint, File{});
    const bool typed = std::ranges::any_of(o.exemplars, [](const Exemplar& exemplar) {
        return exemplar.types || !exemplar.type.empty();
    });
    t.only_if(!o.types.empty(), {"automatic_types", "paint"},
              "a stage with [[terrain.stage.type]]");
    t.check(!o.automatic_types || !typed, {"automatic_types", "exemplar"},
            "automatic_types sorts the exemplars into types; remove it, or the types of "
            "the exemplars");
    t.check(!o.paint || o.types.empty() || o.automatic_types || typed,
            {"paint", "exemplar"},
            "no exemplar has a type to paint with; set automatic_types, or give "
            "[[terrain.stage.exemplar]] a type");
}

void read_synthesis(Table& t, Options& o) {
    t.field("spacing", o.spacing, Number{from(0.0, 1e5)});
    t.field("scale", o.scale, Number{kScales});
    t.field("vertical_scale", o.vertical_scale, Number{kScales});
    t.field("levels", o.levels, Whole{3, 10});
    t.field("orientations", o.orientations, Whole{1, 8});
    t.field("jitter", o.jitter, Number{from(0.0, 4.0)});
    t.field("kappa", o.kappa, Number{from(1.0, 100.0)});
    t.field("breach", o.breach, Flag{});
    const int n = o.orientations;
    t.check(n == 1 || n == 2 || n == 4 || n == 8, {"orientations"},
            "must be 1, 2, 4 or 8");
}

void read_shapes(Table& t, Options& o, TextureNames& names) {
    t.tables("point", o.points, kMostShapes, names);
    t.tables("curve", o.curves, kMostShapes, names);
    t.field("stiffness", o.stiffness, Number{above_to(0.0, 100.0)});
    t.field("pull", o.pull, Number{from(0.0, 1.0)});
    t.only_if(!o.points.empty() || !o.curves.empty(), {"stiffness", "pull"},
              "a stage with points or curves");
}

}  // namespace

void read(Table& t, Options& o) {
    TextureNames names;
    read_types(t, o, names);
    read_exemplars(t, o, names);
    read_painting(t, o);
    read_synthesis(t, o);
    read_shapes(t, o, names);
    t.tables("paste", o.pastes, kMostPastes, names);
    t.field("coherent", o.coherent, Flag{});
    t.field("frozen", o.frozen, File{});
    t.only_if(o.coherent, {"frozen"}, "coherent = true");
}

}  // namespace cydonia::config
