#include <fmt/format.h>

#include <algorithm>

#include "config/reader/elevation_models.h"
#include "config/reader/readers.h"

namespace cydonia::config {

using detail::Filter;
using detail::Kind;
using detail::Mapping;
using detail::Options;
using detail::Search;
using detail::Target;

namespace {

constexpr Name<Filter> kFilters[] = {{"chaikin", Filter::kChaikin},
                                     {"haar", Filter::kHaar},
                                     {"faber", Filter::kFaber},
                                     {"cubic", Filter::kCubic}};
constexpr Name<Search> kSearches[] = {{"random", Search::kRandom},
                                      {"exhaustive", Search::kExhaustive},
                                      {"patchmatch", Search::kPatchMatch}};
constexpr Name<Kind> kKinds[] = {{"copied", Kind::kCopied},
                                 {"multifractal", Kind::kMultifractal},
                                 {"fractal", Kind::kFractal}};

constexpr std::size_t kMostTargets = 64, kMostMappings = 256;
constexpr int kMostLevels = 6;
constexpr Range kScales = above_to(0.0, 1000.0);

}  // namespace

void read(Table& t, Target& target, double scale) {
    t.required("source", target.source, ElevationModel{});
    target.scale = scale;
    t.field("scale", target.scale, Number{kScales});
    t.field("colour", target.colour, Colour{});
}

void read(Table& t, Mapping& m, const Options& o) {
    t.field("target", m.target, Whole{1, std::int64_t{kMostTargets}});
    t.check(m.target <= int(o.targets.size()), {"target"},
            fmt::format("there is no target {}; the stage has {}", m.target,
                        o.targets.size()));
    t.field("from", m.from, Number{from(0.0, 1.0)});
    t.field("to", m.to, Number{from(0.0, 1.0)});
    t.field("size", m.size, Number{above_to(0.0, 1.0)});
    t.field("outline", m.outline, Number{from(0.0, 1.0)});
    t.only_if(!t.has("outline"), {"to", "size"}, "a mapping without an outline");
    t.check(!t.has("outline") || m.outline.size() >= 3, {"outline"},
            "an outline needs at least three corners");
}

void read(Table& t, Options& o) {
    double scale = 1.0;
    t.field("scale", scale, Number{kScales});
    std::vector<std::vector<Source>> found;
    t.field("targets", found, OneOrMore{ElevationModels{}});
    for (const auto& sources : found)
        for (const Source& source : sources) o.targets.push_back({source, {}, scale});
    std::vector<Target> more;
    t.tables("target", more, kMostTargets, scale);
    o.targets.insert(o.targets.end(), more.begin(), more.end());
    t.check(!o.targets.empty(), {"targets", "target"},
            "there is no real land to take details from; name elevation models, or "
            "\"package:jacksboro\" to begin with");
    t.check(o.targets.size() <= kMostTargets, {"targets", "target"},
            fmt::format("{} elevation models are too many; at most {}", o.targets.size(),
                        kMostTargets));

    t.field("levels", o.levels, Whole{1, kMostLevels});
    t.field("strength", o.strength, Number{from(0.0, 100.0)});
    t.field("filter", o.filter, one_of(kFilters));
    t.field("kind", o.kind, one_of(kKinds));
    t.field("adapt", o.adapt, Flag{});
    t.field("search", o.search, one_of(kSearches));
    t.field("block", o.block, Number{from(0.001, 1.0)});
    t.field("candidates", o.candidates, Whole{1, 4096});
    t.field("orientations", o.orientations, Whole{1, 8});
    t.check(o.orientations == 1 || o.orientations == 4 || o.orientations == 8,
            {"orientations"}, "must be 1, 4 or 8");
    t.tables("mapping", o.mappings, kMostMappings, o);
    t.field("paint", o.paint, File{});
    const bool coloured = std::ranges::any_of(
        o.targets, [](const Target& target) { return target.colour.has_value(); });
    t.check(!o.paint || coloured, {"paint", "target"},
            "no target has a colour to paint with; give [[terrain.stage.target]] one");
    t.check(
        !coloured || o.paint, {"target", "paint"},
        "targets have colours, but no paint uses them; add paint or remove the colours");
}

}  // namespace cydonia::config
