// The pastes of a texture stage.

#include <fmt/format.h>

#include <algorithm>

#include "config/reader/texture.h"

namespace cydonia::config {

using texture::Paste;

namespace {

constexpr double kFarthest = 1e6;  // metres, of an outline's corner

// The unit of an exemplar: its number from 1 or its file's name. "terrain" becomes 0.
struct TakenFrom {
    const std::vector<std::string>& exemplars;
    static constexpr bool kVaries = false;

    int read(const Value& value, Files& files) const {
        const int count = static_cast<int>(exemplars.size());
        if (std::holds_alternative<std::int64_t>(value.data))
            return static_cast<int>(Whole{1, count}.read(value, files));
        const std::string name = Text{}.read(value, files);
        if (name == "terrain") return 0;
        const auto known = [&] {
            auto names = exemplars;
            names.emplace_back("terrain");
            return names;
        };
        const auto found = std::ranges::find(exemplars, name);
        if (found == exemplars.end())
            throw Wrong{
                fmt::format("no exemplar '{}'{}", name, suggestion(name, known()))};
        if (std::ranges::count(exemplars, name) > 1)
            throw Wrong{
                fmt::format("several exemplars are called '{}'; give its number", name)};
        return static_cast<int>(found - exemplars.begin()) + 1;
    }
    std::string text(int number) const { return fmt::format("{}", number); }
    std::string schema() const {
        return schema::any_of(
            {Whole{1, static_cast<std::int64_t>(kMostExemplars)}.schema(),
             Text{}.schema()});
    }
};

// The unit of a rotation: degrees clockwise in the file, quarter turns outside.
struct QuarterTurns {
    static constexpr bool kVaries = false;
    int read(const Value& value, Files& files) const {
        const std::int64_t degrees = Whole{0, 270}.read(value, files);
        if (degrees % 90 != 0) throw Wrong{"must be 0, 90, 180 or 270 degrees"};
        return static_cast<int>(degrees / 90);
    }
    std::string text(int turns) const { return fmt::format("{}", 90 * turns); }
    std::string schema() const { return R"({"enum":[0,90,180,270]})"; }
};

void check_region(Table& t, const Paste& paste, bool taken) {
    t.check(!t.has("radius") || !t.has("outline"), {"outline", "radius"},
            "give a radius or an outline, not both");
    t.check(!t.has("outline") || paste.outline.size() >= 3, {"outline"},
            "an outline needs at least three corners");
    t.check(paste.exemplar != 0 || t.has("radius") || t.has("outline"),
            {"radius", "outline", "exemplar"},
            "a part of the terrain needs a radius or an outline");
    t.only_if(!taken || paste.exemplar != 0, {"turn", "mirror"},
              "a paste from an exemplar");
}

}  // namespace

void read(Table& t, Paste& paste, TextureNames& names) {
    read_name(t, paste.name, "paste", names.pastes.size() + 1, names.pastes);
    const bool taken = t.required("exemplar", paste.exemplar, TakenFrom{names.exemplars});
    t.field("from", paste.from, Number{from(0.0, 1.0)});
    t.required("to", paste.to, LengthUnit{});
    t.field("radius", paste.radius, LengthUnit{above(0.0)});
    t.field("outline", paste.outline, Number{from(-kFarthest, kFarthest)});
    t.field("raise", paste.raise, Number{from(-1e5, 1e5)});
    t.field("turn", paste.turn, QuarterTurns{});
    t.field("mirror", paste.mirror, Flag{});
    check_region(t, paste, taken);
}

}  // namespace cydonia::config
