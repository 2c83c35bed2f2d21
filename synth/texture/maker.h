#pragma once

#include <memory>

#include "synth/context.h"
#include "synth/texture/constraints/geometry.h"
#include "synth/texture/database/database.h"
#include "synth/texture/database/types.h"
#include "synth/texture/options.h"
#include "synth/texture/synthesis/pasting.h"
#include "synth/texture/synthesis/synthesis.h"
#include "synth/texture/texture.h"

namespace cydonia::texture {

// Everything that a terrain is made from: the exemplars' database, the constraints and
// the pastes. It can make any part of the terrain.
class Maker {
  public:
    Maker(const Options& options, const Extent& extent, const Context& context);

    // Heights of those samples in metres. Where samples are not the synthesis' own cells,
    // they are interpolated with a cubic.
    Field<float> heights(const Synthesis& synthesis, int x, int y, int width,
                         int height) const;

    const Database& database() const { return *database_; }
    const Geometry& geometry() const { return *geometry_; }
    const geometry::Ground& ground() const { return ground_; }
    const Controls& controls() const { return controls_; }
    // The column or row of the finest level in which a sample's centre lies.
    int cell_of(int sample) const { return static_cast<int>((sample + 0.5) * ratio_); }
    int levels() const { return static_cast<int>(database_->levels.size()); }
    // What points, curves, types and pastes ask of the synthesis.
    const Guidance& guidance() const { return guidance_; }

    // The window of the finest level that the heights of a rectangle of samples need.
    Window window_of(int x, int y, int width, int height) const;

  private:
    Extent extent_;
    Progress& progress_;
    std::shared_ptr<const Database> database_;
    geometry::Ground ground_;
    Controls controls_;
    double ratio_ = 1.0;  // samples to cells of the finest level
    std::unique_ptr<TypeMap> types_;
    std::unique_ptr<Geometry> geometry_;
    std::unique_ptr<Pasting> pasting_;
    Guidance guidance_;
};

}  // namespace cydonia::texture
