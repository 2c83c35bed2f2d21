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

// All that a terrain is made from, ready to make any part of it.
class Maker {
  public:
    Maker(const Options& options, const Extent& extent, const Context& context);

    // Heights of those samples, metres: the synthesis' own cells, or cubic between them.
    Field<float> heights(const Synthesis& synthesis, int x, int y, int width,
                         int height) const;

    const Database& database() const { return *database_; }
    const Geometry& geometry() const { return *geometry_; }
    const Ground& ground() const { return ground_; }
    const Controls& controls() const { return controls_; }
    // The column or row of the finest level that a sample's middle lies in.
    int cell_of(int sample) const { return static_cast<int>((sample + 0.5) * ratio_); }
    int levels() const { return static_cast<int>(database_->levels.size()); }
    // What points, curves, types and pastes ask for.
    const Guidance& guidance() const { return guidance_; }

    // Of the finest level under a rectangle of samples, with what their heights need.
    Window window_of(int x, int y, int width, int height) const;

  private:
    Extent extent_;
    Progress& progress_;
    std::shared_ptr<const Database> database_;
    Ground ground_;
    Controls controls_;
    double ratio_ = 1.0;  // samples to cells of the finest level
    std::unique_ptr<TypeMap> types_;
    std::unique_ptr<Geometry> geometry_;
    std::unique_ptr<Pasting> pasting_;
    Guidance guidance_;
};

}  // namespace cydonia::texture
