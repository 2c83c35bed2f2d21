#pragma once

#include <memory>

#include "field/image.h"
#include "render/scene/shot.h"

namespace cydonia::render {

// Draws frames with Embree in linear Rec.709, as POV-Ray's are: one ray a pixel, a sun
// without extent, skylight in proportion to the sky that is visible, and flat water that
// reflects the sky.
class PreviewLand {
  public:
    // Prepares what all shots of a scene share; cameras and suns may differ. The terrain
    // need not outlive the call. Throws bad_request as View does.
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

// Draws a single frame.
Field<Rgb> preview_frame(const Shot& shot, const Terrain& terrain);

}  // namespace cydonia::render
