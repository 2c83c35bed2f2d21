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
    // The heights less those of the next coarser level; empty on the coarsest.
    Field<float> detail;
    // Sums of heights and of voids over all cells north and west of each corner, so that
    // the mean over a rectangle costs four reads. They have one row and one column more
    // than `heights`.
    Field<double> sums;
    Field<std::int32_t> voids;  // empty: there are no voids

    double mean(int x, int y, int width, int height) const;
    bool any_void(int x, int y, int width, int height) const;
};

struct Sample {
    int type = 0;     // its index in the library
    int example = 0;  // number among all used types' examples, on any level
    std::shared_ptr<const SampleLand> land;
    // The factor of its heights. A level finer than the model itself uses the model's
    // finest level at a smaller scale, because land looks similar at different scales
    // except for its roughness. The roughness is assumed to fall off as it does between
    // the model's two finest levels.
    float gain = 1.0f;
    bool smaller = false;
    // The position of this land's north-west corner from the model's, metres.
    double west = 0.0, north = 0.0;

    int width() const { return land->heights.width(); }
    int height() const { return land->heights.height(); }
};

// All samples at one level of detail.
struct LevelSamples {
    double spacing = 1.0;  // metres
    std::vector<Sample> all;
    std::vector<std::vector<int>> of_type;  // indices in `all` of samples large enough
};

// The examples of the used types at every level. Each level is `ratio` times finer than
// the one before, and the finest has a spacing of `spacing` metres. Types that are not
// used have no samples. Says in `progress` what was done to models. Throws bad_request
// for a model that is no land, a window without land and a used type without samples.
std::vector<LevelSamples> samples_of(const LibraryOptions& library,
                                     std::span<const std::uint8_t> used, double spacing,
                                     int ratio, int levels, Progress& progress);

texture::Exemplar exemplar_of(const Example& example);

// The means of blocks of ratio x ratio cells; at the field's end, of the cells there are.
Field<float> coarser(const Field<float>& fine, int ratio);
// The field, interpolated with a cubic to cells `ratio` times as fine.
Field<float> finer(const Field<float>& coarse, int ratio, int width, int height);

}  // namespace cydonia::genetic
