#pragma once

#include <filesystem>
#include <optional>

#include "field/image.h"
#include "render/options.h"

namespace cydonia::render {

// From POV-Ray's linear Rec.709 to what is delivered: `<name>.exr` (half, ACEScg, with
// metadata) and `<name>.png` (8 bits, through the OCIO display and view, at the scene's
// exposure) in `folder`.
void deliver_frame(const std::filesystem::path& povray_exr,
                   const std::filesystem::path& folder, const std::string& name,
                   const ColourOptions& colour, const Metadata& metadata,
                   std::optional<double> exposure = {});

// What `<name>.png` would be of a frame in memory, linear Rec.709.
Field<Rgb8> picture_of(Field<Rgb> rec709, const ColourOptions& colour,
                       std::optional<double> exposure = {});

// EV that a frame gets by itself: its 90th percentile of light shown as 0.6 of white
// before the view. `exposure` above replaces it, so that a sequence does not flicker.
double own_exposure(const std::filesystem::path& povray_exr);
double own_exposure(Field<Rgb> rec709);

}  // namespace cydonia::render
