#pragma once

#include <string_view>
#include <variant>

#include "synth/context.h"
#include "synth/dem/dem.h"
#include "synth/detail/detail.h"
#include "synth/distance/distance.h"
#include "synth/pareidolia/pareidolia.h"
#include "synth/texture/texture.h"

namespace cydonia {

// The list of methods: one alternative each, one folder each.
using StageOptions = std::variant<distance::Options, pareidolia::Options, dem::Options,
                                  texture::Options, detail::Options>;

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
        Method operator()(const pareidolia::Options&) const {
            return {"pareidolia", pareidolia::kVersion};
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
        Reason operator()(const detail::Options&) const {
            return "its details are put on the whole land";
        }
        Reason operator()(const distance::Options&) const {
            return "its paths cross the whole land";
        }
        Reason operator()(const pareidolia::Options&) const {
            return "its shadows fall across the whole land";
        }
        Reason operator()(const texture::Options& o) const {
            if (o.breach) return "breach follows channels across the whole land";
            if (o.coherent) return "coherent keeps to the whole land of the last run";
            return {};
        }
    };
    return std::visit(Visitor{}, options);
}

// width x height of the first stage's heights, from column x and row y on. Not for a
// stage that is made whole.
inline Field<float> tile(const StageOptions& options, const texture::Extent& extent,
                         const Context& context, int x, int y, int width, int height) {
    return texture::tile(std::get<texture::Options>(options), extent, context, x, y,
                         width, height);
}

}  // namespace cydonia
