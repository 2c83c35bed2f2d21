#pragma once

#include <filesystem>
#include <optional>

#include "field/image.h"
#include "render/options.h"

namespace cydonia::render {

// Converts POV-Ray's linear Rec.709 frame to the delivered files in `folder`:
// `<name>.exr` (half float, ACEScg, with metadata) and `<name>.png` (8 bits, through the
// OCIO display and view, at the scene's exposure). `exposure` in EV replaces
// own_exposure(), so that a sequence does not flicker.
void deliver_frame(const std::filesystem::path& povray_exr,
                   const std::filesystem::path& folder, const std::string& name,
                   const ColourOptions& colour, const Metadata& metadata,
                   std::optional<double> exposure = {});

// The same picture as `<name>.png`, of a frame in memory, linear Rec.709.
Field<Rgb8> picture_of(Field<Rgb> rec709, const ColourOptions& colour,
                       std::optional<double> exposure = {});

// The exposure in EV that is chosen for a single frame (own_stops in
// render/colour/exposure.h).
double own_exposure(const std::filesystem::path& povray_exr);
double own_exposure(Field<Rgb> rec709);

}  // namespace cydonia::render
