#include "field/noise.h"
#include "field/error.h"
namespace cydonia {
double gradient_noise(double, double, std::uint64_t) { throw failure("not built yet"); }
double noise_at(const NoiseOptions&, double, double, std::uint64_t) {
    throw failure("not built yet");
}
Field<float> noise_field(const NoiseOptions&, int, int, double, std::uint64_t) {
    throw failure("not built yet");
}
}  // namespace cydonia
