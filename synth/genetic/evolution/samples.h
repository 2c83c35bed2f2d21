#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "field/field.h"
#include "field/progress.h"
#include "synth/genetic/options.h"
#include "synth/texture/database/exemplars.h"

namespace cydonia::genetic {

// A terrain sample (section V.3.3.3) at one level of detail.
struct SampleLand {
    Field<float> heights;  // metres
    // What the next coarser level lacks of them; empty on the coarsest.
    Field<float> detail;
    // Sums of heights and numbers of voids over all cells north and west of a corner, so
    // that means over rectangles cost four reads: one row and column more than heights.
    Field<double> sums;
    Field<std::int32_t> voids;  // empty: none

    double mean(int x, int y, int width, int height) const;
    bool any_void(int x, int y, int width, int height) const;
};

struct Sample {
    int type = 0;     // its index in the library
    int example = 0;  // counted over used types: the same on all levels
    std::shared_ptr<const SampleLand> land;
    // What its heights are multiplied by. A level finer than the model itself reads the
    // model's finest one smaller: land looks alike from scale to scale, but for how its
    // roughness falls off, and that goes on as it did between the model's finest two.
    float gain = 1.0f;
    bool smaller = false;
    // Metres from the model's north-west corner to this land's.
    double west = 0.0, north = 0.0;

    int width() const { return land->heights.width(); }
    int height() const { return land->heights.height(); }
};

// All samples at one level of detail.
struct LevelSamples {
    double spacing = 1.0;  // metres
    std::vector<Sample> all;
    std::vector<std::vector<int>> of_type;  // indices in `all`, those with land enough
};

// The examples of those types at every level, `ratio` times finer from one to the next,
// the finest with `spacing` metres from sample to sample. Types that are not used have no
// samples. What was done to models goes to `progress`. Throws bad_request: a model that
// is no land, a window that holds none, a used type without samples.
std::vector<LevelSamples> samples_of(const LibraryOptions& library,
                                     std::span<const std::uint8_t> used, double spacing,
                                     int ratio, int levels, Progress& progress);

texture::Exemplar exemplar_of(const Example& example);

// The means of blocks of ratio x ratio cells; where the field ends, of those there are.
Field<float> coarser(const Field<float>& fine, int ratio);
// Cubic, ratio times as fine.
Field<float> finer(const Field<float>& coarse, int ratio, int width, int height);

}  // namespace cydonia::genetic
