#pragma once

#include <memory>

#include "field/image.h"
#include "render/scene/shot.h"

namespace cydonia::render {

// Frames by Embree, linear Rec.709 as POV-Ray's: one ray a pixel, the sun a point, light
// from the sky by how much of it is seen, flat water that mirrors the sky.
class PreviewLand {
  public:
    // What all shots of a scene share; cameras and suns may differ. The terrain need not
    // outlive the call. Throws bad_request as View does.
    PreviewLand(const Shot& shot, const Terrain& terrain);
    ~PreviewLand();
    PreviewLand(PreviewLand&&) noexcept;

    Field<Rgb> frame(const Shot& shot);

  private:
    struct Light;
    class Parts;
    class Picture;
    std::unique_ptr<Parts> parts_;
};

// A single one.
Field<Rgb> preview_frame(const Shot& shot, const Terrain& terrain);

}  // namespace cydonia::render
