#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <variant>

#include "synth/context.h"
#include "synth/dem/dem.h"
#include "synth/detail/detail.h"
#include "synth/distance/distance.h"
#include "synth/genetic/genetic.h"
#include "synth/pareidolia/pareidolia.h"
#include "synth/sketch/sketch.h"
#include "synth/texture/texture.h"

namespace cydonia {

// The list of methods: one alternative each, one folder each.
using StageOptions =
    std::variant<distance::Options, pareidolia::Options, dem::Options, texture::Options,
                 detail::Options, sketch::Options, genetic::Options>;

inline Terrain run(const StageOptions& options, const Terrain& terrain,
                   const Context& context) {
    return std::visit([&](const auto& o) { return run(o, terrain, context); }, options);
}

struct Method {
    std::string_view name;  // in scene files
    int version;            // part of a stage's cache key
};

inline Method method_of(const StageOptions& options) {
    struct Visitor {
        Method operator()(const dem::Options&) const { return {"dem", dem::kVersion}; }
        Method operator()(const detail::Options&) const {
            return {"detail", detail::kVersion};
        }
        Method operator()(const distance::Options&) const {
            return {"distance", distance::kVersion};
        }
        Method operator()(const genetic::Options&) const {
            return {"genetic", genetic::kVersion};
        }
        Method operator()(const pareidolia::Options&) const {
            return {"pareidolia", pareidolia::kVersion};
        }
        Method operator()(const sketch::Options&) const {
            return {"sketch", sketch::kVersion};
        }
        Method operator()(const texture::Options&) const {
            return {"texture", texture::kVersion};
        }
    };
    return std::visit(Visitor{}, options);
}

// Whether a stage's land follows from what it remembers too, besides all else that it is
// made from.
inline bool follows_memory(const StageOptions& options) {
    const auto* texture = std::get_if<texture::Options>(&options);
    return texture && texture->coherent;
}

// Why the land of a stage is made whole; empty where each of its cells depends on a
// bounded part of the plane, and tile() makes any part of it alone.
inline std::string_view whole_because(const StageOptions& options) {
    struct Visitor {
        using Reason = std::string_view;
        Reason operator()(const dem::Options&) const { return "it is one model"; }
        Reason operator()(const detail::Options& o) const {
            if (o.search == detail::Search::kPatchMatch)
                return "PatchMatch goes on from block to block; search = \"random\" does "
                       "not";
            if (o.paint || !o.mappings.empty())
                return "paint and mappings lie over the whole land";
            return {};
        }
        Reason operator()(const distance::Options&) const {
            return "its paths cross the whole land";
        }
        Reason operator()(const genetic::Options&) const {
            return "its regions are judged as wholes";
        }
        Reason operator()(const pareidolia::Options&) const {
            return "its shadows fall across the whole land";
        }
        Reason operator()(const sketch::Options&) const {
            return "its landforms are as large as they are drawn";
        }
        Reason operator()(const texture::Options& o) const {
            if (o.breach) return "breach follows channels across the whole land";
            if (o.coherent) return "coherent keeps to the whole land of the last run";
            return {};
        }
    };
    return std::visit(Visitor{}, options);
}

// Whether a stage makes land out of nothing, and need not have any before it.
inline bool makes_land(const StageOptions& options) {
    return !std::holds_alternative<detail::Options>(options);
}

// width x height of the heights after a number of stages, from column x and row y on;
// `context` is that of a stage, counted from 0. Not for stages that are made whole.
inline Field<float> tile(std::span<const StageOptions* const> stages,
                         const Extent& extent,
                         const std::function<Context(int stage)>& context, int x, int y,
                         int width, int height) {
    const int last = static_cast<int>(stages.size()) - 1;
    if (const auto* o = std::get_if<detail::Options>(stages.back()))
        return detail::tile(
            *o, extent,
            [&](int from_x, int from_y, int columns, int rows) {
                return tile(stages.first(stages.size() - 1), extent, context, from_x,
                            from_y, columns, rows);
            },
            context(last), x, y, width, height);
    return texture::tile(std::get<texture::Options>(*stages.back()), extent,
                         context(last), x, y, width, height);
}

// How many samples beyond a tile its heights depend on.
inline int reach(std::span<const StageOptions* const> stages, const Extent& extent) {
    constexpr int kTexture = 128;
    int samples = kTexture;
    for (const StageOptions* stage : stages)
        if (const auto* o = std::get_if<detail::Options>(stage))
            samples += detail::reach(*o, extent);
    return samples;
}

}  // namespace cydonia
