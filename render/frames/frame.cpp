#include "render/frames/frame.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "field/error.h"
#include "field/parallel.h"
#include "render/colour/colour.h"
#include "render/colour/exposure.h"

namespace cydonia::render {
namespace {

constexpr float kLargestHalf = 65504.0f;

// A grade before the view transform, since the transform and haze flatten landscapes.
constexpr float kMiddleGrey = 0.18f;
constexpr float kContrast = 1.18f;
constexpr float kSaturation = 1.15f;

// Replaces NaN and infinity, which denoisers and compositors would spread to neighbours.
float finite(float value) {
    return std::isnan(value) ? 0.0f : std::clamp(value, -kLargestHalf, kLargestHalf);
}

Field<Rgb> acescg_of(Field<Rgb> frame) {
    parallel_for(frame.height(), [&](int y) {
        for (Rgb& pixel : frame.row(y))
            pixel = acescg_from_rec709(
                {finite(pixel[0]), finite(pixel[1]), finite(pixel[2])});
    });
    return frame;
}

float with_contrast(float value) {
    return value > 0.0f ? kMiddleGrey * std::pow(value / kMiddleGrey, kContrast) : value;
}

Rgb graded(const Rgb& acescg) {
    const Rgb value{with_contrast(acescg[0]), with_contrast(acescg[1]),
                    with_contrast(acescg[2])};
    const float grey = luminance(value);
    return {grey + kSaturation * (value[0] - grey),
            grey + kSaturation * (value[1] - grey),
            grey + kSaturation * (value[2] - grey)};
}

Field<Rgb> developed(Field<Rgb> acescg, double stops) {
    const float gain = static_cast<float>(std::exp2(stops));
    parallel_for(acescg.height(), [&](int y) {
        for (Rgb& pixel : acescg.row(y))
            pixel = graded({gain * pixel[0], gain * pixel[1], gain * pixel[2]});
    });
    return acescg;
}

}  // namespace

void deliver_frame(const std::filesystem::path& povray_exr,
                   const std::filesystem::path& folder, const std::string& name,
                   const ColourOptions& colour, const Metadata& metadata,
                   std::optional<double> exposure) {
    const Display display(colour);
    Field<Rgb> frame = acescg_of(read_exr_rgb(povray_exr));
    const double stops = (exposure ? *exposure : own_stops(frame)) + colour.exposure;

    Metadata told = metadata;
    told["cydonia:exposure"] = fmt::format("{:.3f} EV", stops);
    told["cydonia:display"] = display.display();
    told["cydonia:view"] = display.view();
    write_exr(folder / (name + ".exr"), frame, told, Primaries::kAcesCg);
    write_png(folder / (name + ".png"),
              display.shown(developed(std::move(frame), stops)));
}

Field<Rgb8> picture_of(Field<Rgb> rec709, const ColourOptions& colour,
                       std::optional<double> exposure) {
    const Display display(colour);
    Field<Rgb> frame = acescg_of(std::move(rec709));
    const double stops = (exposure ? *exposure : own_stops(frame)) + colour.exposure;
    return display.shown(developed(std::move(frame), stops));
}

double own_exposure(const std::filesystem::path& povray_exr) {
    return own_exposure(read_exr_rgb(povray_exr));
}

double own_exposure(Field<Rgb> rec709) { return own_stops(acescg_of(std::move(rec709))); }

}  // namespace cydonia::render
