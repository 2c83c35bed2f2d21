#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string_view>
#include <variant>

#include "field/source.h"
#include "synth/context.h"

namespace cydonia {

// What a method says of a stage with certain options.
struct Method {
    std::string_view name;  // in scene files
    int version = 0;        // part of a stage's cache key
    // Why the land is made whole; empty where each of its cells depends on a bounded part
    // of the plane, so that tile() can make any part of it alone.
    std::string_view whole_because = {};
    bool makes_land = true;  // out of nothing: it need not have any land before it
    // The land follows from what the stage remembers of its last run (Context::memory)
    // too, besides all else that it is made from.
    bool follows_memory = false;
};

// Heights of the land before a stage: width x height, from column x and row y on.
using Heights = std::function<Field<float>(int x, int y, int width, int height)>;

// A method is a folder with a struct Options and, in the same namespace, these functions
// of it. Nothing else in synth/ names it but the list in synth/stage.h.
//
//   Terrain run(const Options&, const Terrain&, const Context&);
//   Method method_of(const Options&);
//   // Bytes, predicted, that run() takes at most for a land of so many cells.
//   std::uint64_t peak_memory(const Options&, std::uint64_t cells, std::uint64_t
//   threads);
//
// Where Method::whole_because can be empty also
//
//   // How many samples beyond a tile its heights depend on.
//   int reach(const Options&, const Extent&);
//   // Heights that run() gives, width x height from column x and row y on. Without
//   // `before` where it makes land out of nothing.
//   Field<float> tile(const Options&, const Extent&, const Heights& before,
//                     const Context&, int x, int y, int width, int height);
template <class Options>
concept Runs = requires(const Options& o, const Terrain& terrain, const Context& c) {
    { run(o, terrain, c) } -> std::same_as<Terrain>;
};
template <class Options>
concept SaysWhatItIs = requires(const Options& o) {
    { method_of(o) } -> std::same_as<Method>;
};
template <class Options>
concept PredictsMemory = requires(const Options& o, std::uint64_t n) {
    { peak_memory(o, n, n) } -> std::same_as<std::uint64_t>;
};
template <class Options>
concept TilesOfNothing = requires(const Options& o, const Extent& extent,
                                  const Context& c, int i) {
    { reach(o, extent) } -> std::same_as<int>;
    { tile(o, extent, c, i, i, i, i) } -> std::same_as<Field<float>>;
};
template <class Options>
concept TilesOfLand = requires(const Options& o, const Extent& extent,
                               const Heights& before, const Context& c, int i) {
    { reach(o, extent) } -> std::same_as<int>;
    { tile(o, extent, before, c, i, i, i, i) } -> std::same_as<Field<float>>;
};
template <class Options>
concept Tiles = TilesOfNothing<Options> || TilesOfLand<Options>;

// Fails to compile, and says what is missing, where that is no method's.
template <class Options>
constexpr bool is_method() {
    static_assert(Runs<Options>,
                  "a method needs Terrain run(const Options&, const Terrain&, const "
                  "Context&) beside its Options (synth/method.h)");
    static_assert(SaysWhatItIs<Options>,
                  "a method needs Method method_of(const Options&) beside its Options "
                  "(synth/method.h)");
    static_assert(
        PredictsMemory<Options>,
        "a method needs std::uint64_t peak_memory(const Options&, std::uint64_t "
        "cells, std::uint64_t threads) beside its Options (synth/method.h)");
    return true;
}

// Cells of an elevation model, by its header; one that does not tell has at most one a
// byte, and none has more than field/dem.h reads.
std::uint64_t model_cells(const Source& source);

// A stage is one of several methods' options.
template <class... Options>
Terrain run(const std::variant<Options...>& stage, const Terrain& terrain,
            const Context& context) {
    static_assert((is_method<Options>() && ...));
    return std::visit([&](const auto& o) { return run(o, terrain, context); }, stage);
}

template <class... Options>
Method method_of(const std::variant<Options...>& stage) {
    static_assert((is_method<Options>() && ...));
    return std::visit([](const auto& o) { return method_of(o); }, stage);
}

template <class... Options>
std::uint64_t peak_memory(const std::variant<Options...>& stage, std::uint64_t cells,
                          std::uint64_t threads) {
    static_assert((is_method<Options>() && ...));
    return std::visit([&](const auto& o) { return peak_memory(o, cells, threads); },
                      stage);
}

// How many samples beyond a tile the heights after all these stages depend on.
template <class... Options>
int reach(std::span<const std::variant<Options...>* const> stages, const Extent& extent) {
    int samples = 0;
    for (const auto* stage : stages)
        samples += std::visit(
            [&]<class O>(const O& o) {
                if constexpr (Tiles<O>) return reach(o, extent);
                return 0;
            },
            *stage);
    return samples;
}

// width x height of the heights after these stages, from column x and row y on;
// `context` is that of a stage, counted from 0. Not for stages that are made whole.
template <class... Options>
Field<float> tile(std::span<const std::variant<Options...>* const> stages,
                  const Extent& extent, const std::function<Context(int stage)>& context,
                  int x, int y, int width, int height) {
    const auto stages_before = stages.first(stages.size() - 1);
    const Heights before = [&](int from_x, int from_y, int columns, int rows) {
        return tile(stages_before, extent, context, from_x, from_y, columns, rows);
    };
    const Context own = context(static_cast<int>(stages_before.size()));
    return std::visit(
        [&]<class O>(const O& o) -> Field<float> {
            if constexpr (TilesOfLand<O>)
                return tile(o, extent, before, own, x, y, width, height);
            else if constexpr (TilesOfNothing<O>)
                return tile(o, extent, own, x, y, width, height);
            else
                throw std::logic_error("a stage that is made whole has no tiles");
        },
        *stages.back());
}

}  // namespace cydonia
