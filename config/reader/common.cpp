#include <fmt/format.h>

#include "config/reader/readers.h"
#include "field/vec.h"

namespace cydonia::config {
namespace {

constexpr Name<NoiseOptions::Kind> kNoiseKinds[] = {
    {"fbm", NoiseOptions::Kind::kFbm},
    {"ridged", NoiseOptions::Kind::kRidged},
};

constexpr double kHighest = 89.9;  // degrees

}  // namespace

std::string SunElevation::schema() const {
    return Degrees{above_to(0.0, kHighest)}.schema();
}

double SunElevation::read(const Value& value, Files& files) const {
    const double elevation = Degrees{}.read(value, files);
    if (elevation <= 0.0)
        throw Wrong{
            fmt::format("a sun at {:.6g} degrees is at or below the horizon; must be "
                        "above 0 and at most {} degrees",
                        degrees(elevation), kHighest)};
    if (elevation > radians(kHighest))
        throw Wrong{
            fmt::format("a sun at {:.6g} degrees is overhead and casts no shadow; must "
                        "be above 0 and at most {} degrees",
                        degrees(elevation), kHighest)};
    return elevation;
}

void read(Table& t, Sun& sun) {
    t.required("azimuth", sun.azimuth, kAzimuth);
    t.required("elevation", sun.elevation, SunElevation{});
}

void read(Table& t, NoiseOptions& noise) {
    t.field("kind", noise.kind, one_of(kNoiseKinds));
    t.field("h", noise.h, Number{from(0.0, 10.0)});
    t.field("lacunarity", noise.lacunarity, Number{above_to(1.0, 10.0)});
    t.field("octaves", noise.octaves, Whole{0, 16});
    t.field("grid", noise.grid, Number{above_to(0.0, 4096.0)});
    t.field("scale", noise.scale, LengthUnit{at_least(0.0)});
    t.field("offset", noise.offset, Number{from(0.0, 10.0)});
    t.field("gain", noise.gain, Number{from(0.0, 100.0)});
    t.only_if(noise.kind == NoiseOptions::Kind::kRidged, {"offset", "gain"},
              "kind = \"ridged\"");
}

void check_edge_weights(Table& t, double mean, double deviation) {
    t.check(deviation < mean,
            {"edge_weight_deviation_map", "edge_weight_deviation", "mean_edge_weight_map",
             "mean_edge_weight"},
            fmt::format("edge_weight_deviation {} must be below mean_edge_weight {}",
                        deviation, mean));
}

}  // namespace cydonia::config
