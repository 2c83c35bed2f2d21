#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "field/image.h"
#include "render/passes/options.h"
#include "render/passes/view.h"

namespace cydonia::render {

// One part of a frame's EXR: channels of one kind, pixel by pixel.
struct PassLayer {
    std::string name;                   // "normal"
    std::vector<std::string> channels;  // "N.X", "N.Y", "N.Z"
    bool half = true;                   // how it is stored; else 32 bits
    std::vector<float> values;          // those of a pixel together
};

// Draped over the land as ground.png is, any number of pixels: empty where not known,
// and what needs them is then left out.
struct PassMaps {
    Field<std::uint8_t> materials;
    Field<std::uint8_t> types;    // 0: none
    Field<float> sky_visibility;  // 0 to 1
};

// Z where there is nothing but sky, metres; all else is 0 there.
inline constexpr float kFarDepth = 1e10f;

// The passes asked for, without those whose data are missing.
std::vector<PassLayer> passes(const View& view, const Field<SeenPoint>& points,
                              const Sun& sun, const PassMaps& maps,
                              const std::vector<Pass>& which);

// Where each point is in another camera's frame, less where it is in this one: pixels to
// the right and down, of points that do not move. "motion" with motion.X and motion.Y.
PassLayer motion_pass(const Field<SeenPoint>& points, const CameraRays& now,
                      const CameraRays& then);

// One EXR of several parts: the frame's beauty first (linear ACEScg, R G B), unless it is
// empty. Throws bad_request where sizes differ.
void write_passes(const std::filesystem::path& path, const Field<Rgb>& beauty,
                  const std::vector<PassLayer>& layers, int width, int height,
                  const Metadata& metadata);

}  // namespace cydonia::render
