#include <algorithm>
#include <cmath>

#include "field/files.h"
#include "field/image.h"
#include "render/report/report.h"

namespace fs = std::filesystem;

namespace cydonia::render {
namespace {

constexpr int kQuality =
    84;  // JPEG quality: the lowest that shows no blocks in a clear sky

Field<Rgb8> over_white(const Field<Rgba8>& picture) {
    Field<Rgb8> rgb(picture.width(), picture.height());
    std::ranges::transform(picture, rgb.begin(), [](const Rgba8& pixel) {
        Rgb8 over;
        for (std::size_t i = 0; i < 3; ++i)
            over[i] = static_cast<std::uint8_t>(255 - (255 - pixel[i]) * pixel[3] / 255);
        return over;
    });
    return rgb;
}

Field<Rgb8> smaller(const Field<Rgb8>& picture, int width, int height) {
    Field<Rgb8> small(width, height);
    for (std::size_t i = 0; i < 3; ++i) {
        Field<float> channel(picture.width(), picture.height());
        std::ranges::transform(picture, channel.begin(),
                               [i](const Rgb8& pixel) { return float(pixel[i]); });
        channel = resized(channel, width, height);
        for (std::size_t k = 0; k < small.size(); ++k)
            small[k][i] = static_cast<std::uint8_t>(std::lround(channel[k]));
    }
    return small;
}

}  // namespace

ReportPicture report_picture(const fs::path& folder, const std::string& file,
                             const std::string& label, int most) {
    Field<Rgb8> rgb = over_white(read_rgba(open_source(folder / file)));
    const int longer = std::max(rgb.width(), rgb.height());
    if (longer > most) {
        const auto side = [&](int pixels) {
            return std::max(
                1, static_cast<int>(std::lround(double(pixels) * most / longer)));
        };
        rgb = smaller(rgb, side(rgb.width()), side(rgb.height()));
    }
    return {label, file, jpeg_of(rgb, kQuality), rgb.width(), rgb.height()};
}

std::string three_js() {
    for (const char* path : {"/usr/share/javascript/three/three.min.js",
                             "/usr/share/nodejs/three/build/three.min.js"}) {
        std::error_code none;
        if (fs::is_regular_file(path, none)) return read_text(path);
    }
    return {};
}

}  // namespace cydonia::render
