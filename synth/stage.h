#pragma once

#include <string_view>
#include <variant>

#include "synth/context.h"
#include "synth/dem/dem.h"
#include "synth/distance/distance.h"
#include "synth/pareidolia/pareidolia.h"
#include "synth/texture/texture.h"

namespace cydonia {

// The list of methods: one alternative each, one folder each.
using StageOptions =
    std::variant<distance::Options, pareidolia::Options, dem::Options, texture::Options>;

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

}  // namespace cydonia
