#pragma once

#include "field/image.h"
#include "render/pov/scene.h"

namespace cydonia::render {

// A frame by Embree from the shot's camera, linear Rec.709 as POV-Ray's: one ray a pixel,
// the sun a point, light from the sky by how much of it is seen, flat water that mirrors
// the sky. Throws bad_request as View does.
Field<Rgb> preview_frame(const Shot& shot, const Terrain& terrain);

}  // namespace cydonia::render
