#include "synth/texture/synthesis/keeping.h"

#include <bit>
#include <utility>

#include "field/random.h"
#include "synth/texture/database/types.h"

namespace cydonia::texture {
namespace {

constexpr float kCoherent = 0.25f;  // section 5.3

// A hash of what is asked of each cell of a window; 0: nothing.
Field<std::uint64_t> asked_of(const Guidance& guidance, const PinnedRegion& pasted,
                              const Window& window) {
    Field<std::uint64_t> asked(window.width, window.height);
    const auto add = [](std::uint64_t& to, std::uint64_t what) { to = mix(to ^ what); };
    if (guidance.pulls) {
        const Field<Pull> pulls = guidance.pulls(window);
        for (std::size_t i = 0; i < asked.size(); ++i)
            if (pulls[i].reach > 0.0f)
                add(asked[i], hash_of({std::bit_cast<std::uint32_t>(pulls[i].target),
                                       std::bit_cast<std::uint32_t>(pulls[i].distance),
                                       std::bit_cast<std::uint32_t>(pulls[i].reach)}));
    }
    if (guidance.types) {
        const Field<TypeSet> types = guidance.types(window);
        for (std::size_t i = 0; i < asked.size(); ++i)
            if (types[i] != kAnyType) add(asked[i], types[i]);
    }
    for (std::size_t i = 0; i < pasted.weights.size(); ++i)
        if (pasted.weights[i] == 0.0f)
            add(asked[i], hash_of({pasted.origins[i].x, pasted.origins[i].y,
                                   std::uint32_t(pasted.offsets[i])}));
    return asked;
}

}  // namespace

Keeping::Keeping(const Guidance& guidance, std::optional<Run> last,
                 std::optional<CellSet> frozen, const Controls& controls, int levels)
    : guidance_(guidance),
      last_(std::move(last)),
      frozen_(std::move(frozen)),
      finest_guided_(std::min(controls.finest + kFinestGuided, levels - 1)),
      windows_(std::size_t(levels)) {
    run_.asked.resize(std::size_t(levels));
}

bool Keeping::same_asked(const Window& window, int x, int y) const {
    const int up = std::max(0, finest_guided_ - window.level);
    const auto level = std::size_t(window.level + up);
    const Window& now = windows_[level];
    const std::vector<Synthesis>& passes = last_->passes[level];
    if (passes.empty()) return false;
    const Window& then = passes.front().window;
    const int ax = x >> up, ay = y >> up;
    if (!now.contains(ax, ay) || !then.contains(ax, ay)) return false;
    return run_.asked[level](ax - now.x, ay - now.y) ==
           last_->asked[level](ax - then.x, ay - then.y);
}

PinnedRegion Keeping::pinned(const Window& window, int pass) {
    const PinnedRegion pasted =
        guidance_.pinned ? guidance_.pinned(window, pass) : PinnedRegion{};
    const auto level = std::size_t(window.level);
    if (pass == 0 && window.level >= finest_guided_) {
        windows_[level] = window;
        run_.asked[level] = asked_of(guidance_, pasted, window);
    }
    if (!last_ || level >= last_->passes.size() || last_->passes[level].empty())
        return pasted;

    const std::vector<Synthesis>& passes = last_->passes[level];
    const Synthesis& last = passes[std::min(std::size_t(pass), passes.size() - 1)];
    PinnedRegion pinned{{window.width, window.height, 1.0f},
                        {window.width, window.height},
                        {window.width, window.height}};
    for (int row = 0; row < window.height; ++row) {
        for (int column = 0; column < window.width; ++column) {
            const int x = window.x + column, y = window.y + row;
            const std::size_t i = pinned.origins.index(column, row);
            if (!pasted.weights.empty() && pasted.weights[i] == 0.0f) {
                pinned.weights[i] = 0.0f;
                pinned.origins[i] = pasted.origins[i];
                pinned.offsets[i] = pasted.offsets[i];
            } else if (last.window.contains(x, y)) {
                const std::size_t j =
                    last.origins.index(x - last.window.x, y - last.window.y);
                pinned.origins[i] = last.origins[j];
                pinned.offsets[i] = last.offsets[j];
                if (frozen_ && frozen_->at(window.level).holds(x, y))
                    pinned.weights[i] = 0.0f;
                else if (same_asked(window, x, y))
                    pinned.weights[i] = kCoherent;
            }
        }
    }
    return pinned;
}

const Run& Keeping::finished(std::uint64_t database) {
    run_.database = database;
    return run_;
}

}  // namespace cydonia::texture
