#pragma once

#include <atomic>
#include <string>
#include <utility>
#include <vector>

#include "field/dem.h"
#include "field/noise.h"
#include "synth/texture/database/appearance.h"
#include "synth/texture/database/matches.h"
#include "synth/texture/database/pyramid.h"
#include "tests/field/temporary_folder.h"

namespace cydonia::texture {

template <class Height>
Field<float> heights_of(int width, int height, const Height& height_at) {
    Field<float> heights(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            heights(x, y) = static_cast<float>(height_at(x, y));
    return heights;
}

// Land without symmetries, some hundred metres high.
inline Field<float> rough(int width, int height, std::uint64_t seed = 1) {
    NoiseOptions options;
    options.h = 1.0;
    options.octaves = 5;
    return noise_field(options, width, height, 300.0, seed);
}

inline Land land_of(Field<float> heights) {
    Field<std::uint8_t> types(heights.width(), heights.height(), kNoType);
    return {"land", std::move(heights), {}, std::move(types)};
}

// What lies under a step from the middle of the result is what lies under the turned step
// from the middle of the land.
inline Field<float> turned_land(const Field<float>& land, int orientation) {
    const bool across = orientation & 1;
    const int width = across ? land.height() : land.width();
    const int height = across ? land.width() : land.height();
    return heights_of(width, height, [&](int x, int y) {
        const Step halves = turned(orientation, {2 * x + 1 - width, 2 * y + 1 - height});
        return land((halves.x + land.width() - 1) / 2,
                    (halves.y + land.height() - 1) / 2);
    });
}

// Heights of all lands within 30,000 units of 0.
inline constexpr HeightScale kScale{0.0, 0.05};

inline LevelArrays level_of(const std::vector<Land>& lands) {
    LevelArrays level = std::move(pyramid_of(lands, 1).front());
    add_appearance(level, modes_of(level), kScale);
    return level;
}

// As an exemplar in a file, cells of 10 m unless told.
inline Exemplar exemplar_of(const TemporaryFolder& folder, const std::string& name,
                            Field<float> heights, double spacing = 10.0) {
    Terrain terrain;
    terrain.spacing = spacing;
    terrain.heights = std::move(heights);
    write_geotiff(folder / name, terrain);
    return {open_source(folder / name), {}, {}};
}

// Remembers what is said; ends at a given report, as Ctrl-C does.
class Listener final : public Progress {
  public:
    void step(std::string_view name) override { steps.emplace_back(name); }
    void report(double) override {
        if (interrupt_at-- == 0) throw Interrupted{};
    }
    void note(std::string_view sentence) override { notes.emplace_back(sentence); }
    void warn(std::string_view sentence) override { warnings.emplace_back(sentence); }

    std::vector<std::string> steps, notes, warnings;
    std::atomic<int> interrupt_at = -1;
};

}  // namespace cydonia::texture
