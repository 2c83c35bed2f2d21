#pragma once

#include <cstdint>
#include <string>

#include "synth/stage.h"

namespace cydonia {

// The most memory that each kind of step takes, in bytes. The predictions are bytes a
// cell and a pixel, measured at 512, 1024 and 2048 samples and rounded up;
// bench/memory.sh compares them with real runs. `cells` are samples of the terrain,
// `pixels` those of a frame.
namespace memory {

std::uint64_t of_stage(const StageOptions& options, std::uint64_t cells,
                       std::uint64_t threads);
// To make tiles of width x height samples of a land and to put them together.
std::uint64_t of_tile(std::span<const StageOptions* const> stages, const Extent& land,
                      int width, int height, std::uint64_t threads);
std::uint64_t of_export(std::uint64_t cells);
// At most `samples` along the longer side.
std::uint64_t of_solid(std::uint64_t cells, int samples);
std::uint64_t of_heights(std::uint64_t cells, int samples, bool as_text);
// `cells` are those of the land as it is drawn, here and below.
std::uint64_t of_gltf(std::uint64_t cells, int samples);
std::uint64_t of_check(std::uint64_t cells);
std::uint64_t of_emit(std::uint64_t cells);
std::uint64_t of_trace(std::uint64_t cells, std::uint64_t pixels);
// For all passes of a frame.
std::uint64_t of_passes(std::uint64_t cells, std::uint64_t pixels);
std::uint64_t of_delivery(std::uint64_t pixels);

// What this process may still take: the least of the machine's available memory, the
// limit of its control group and its own address-space limit.
std::uint64_t available();

// Throws failure() with both figures when `needed` cannot fit.
void refuse_unless_it_fits(std::uint64_t needed, std::uint64_t available);

}  // namespace memory

// "310 MB", "2.4 GB".
std::string bytes_text(std::uint64_t bytes);

}  // namespace cydonia
