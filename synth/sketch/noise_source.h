#pragma once

#include <cstdint>
#include <vector>

#include "field/terrain.h"
#include "synth/context.h"
#include "synth/sketch/landform.h"
#include "synth/sketch/options.h"

namespace cydonia::sketch {

// Makes the noise of landforms that the options ask for: of wavelets, or of the bands of
// real land.
class NoiseSource {
  public:
    // Throws bad_request for real land that cannot be read or is level.
    NoiseSource(const Options& options, const Terrain& terrain, const Context& context);

    // The noise for a feature that will be made on the land. May set the strength of the
    // landforms' bands.
    Noise of(std::vector<Landform>& landforms, const Field<float>& land,
             std::uint64_t seed) const;

  private:
    void measure();
    double stretch() const;
    Field<float> detailed(const std::vector<Landform>& landforms,
                          const Field<float>& land, int levels, std::uint64_t seed) const;

    const Options& options_;
    const Context& context_;
    double spacing_, model_spacing_ = 1.0;
    std::vector<double> strength_;  // of bands, metres; empty: the silhouettes' own
    Field<float> synthesised_;
};

}  // namespace cydonia::sketch
