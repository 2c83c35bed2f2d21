#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "field/image.h"
#include "render/passes/options.h"
#include "render/passes/view.h"

namespace cydonia::render {

// One part of a frame's EXR. Values are stored pixel by pixel.
struct PassLayer {
    std::string name;                   // "normal"
    std::vector<std::string> channels;  // "N.X", "N.Y", "N.Z"
    bool half = true;           // stored as half floats, otherwise as 32-bit floats
    std::vector<float> values;  // the channels of a pixel are adjacent
};

// Maps that cover the land as ground.png does, of any number of pixels. A pass that needs
// an empty map is left out.
struct PassMaps {
    Field<std::uint8_t> materials;
    Field<std::uint8_t> types;    // 0: none
    Field<float> sky_visibility;  // 0 to 1
};

// The depth of the sky, metres. All other passes are 0 there.
inline constexpr float kFarDepth = 1e10f;

// The passes asked for, without those whose data are missing.
std::vector<PassLayer> passes(const View& view, const Field<SeenPoint>& points,
                              const Sun& sun, const PassMaps& maps,
                              const std::vector<Pass>& which);

// The pass "motion" with the channels motion.X and motion.Y: the position of each point
// in the frame of camera `then` minus that in the frame of `now`, pixels to the right and
// down. Only the camera moves.
PassLayer motion_pass(const Field<SeenPoint>& points, const CameraRays& now,
                      const CameraRays& then);

// Writes one EXR of several parts. The first is the frame itself (`beauty`, linear
// ACEScg), unless it is empty. Throws bad_request when sizes differ.
void write_passes(const std::filesystem::path& path, const Field<Rgb>& beauty,
                  const std::vector<PassLayer>& layers, int width, int height,
                  const Metadata& metadata);

}  // namespace cydonia::render
