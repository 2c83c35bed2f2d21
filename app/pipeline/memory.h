#pragma once

#include <cstdint>
#include <string>

#include "synth/stage.h"

namespace cydonia {

// The most memory each step takes, in bytes, predicted before it is taken. Measured peaks
// over samples from 256 to 4096, rounded up; tests/app/memory_test.cpp and
// bench/memory.sh hold them against real runs. `cells` are samples of the terrain.
namespace memory {

std::uint64_t of_stage(const StageOptions& options, std::uint64_t cells);
std::uint64_t of_export(std::uint64_t cells);
std::uint64_t of_check(std::uint64_t cells);
std::uint64_t of_emit(std::uint64_t cells);
std::uint64_t of_trace(std::uint64_t cells, std::uint64_t pixels);
std::uint64_t of_delivery(std::uint64_t pixels);

// What this process may still take: the machine's available memory, its control group's
// limit and its own address-space limit, whichever is least.
std::uint64_t available();

// Throws failure() with both figures when `needed` cannot fit.
void refuse_unless_it_fits(std::uint64_t needed, std::uint64_t available);

}  // namespace memory

// "310 MB", "2.4 GB".
std::string bytes_text(std::uint64_t bytes);

}  // namespace cydonia
