#pragma once

#include <filesystem>

#include "field/image.h"
#include "render/options.h"

namespace cydonia::render {

// From POV-Ray's linear Rec.709 to what is delivered: `<name>.exr` (half, ACEScg, with
// metadata) and `<name>.png` (8 bits, through the OCIO display and view, at the scene's
// exposure) in `folder`.
void deliver_frame(const std::filesystem::path& povray_exr,
                   const std::filesystem::path& folder, const std::string& name,
                   const ColourOptions& colour, const Metadata& metadata);

}  // namespace cydonia::render
