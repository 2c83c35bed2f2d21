#include "render/shadow/overlay.h"

#include "render/shadow/score.h"

namespace cydonia::render {

namespace {

// Close to the palette of Okabe and Ito, with lightness spread: to the colour-blind any
// two but the greys differ by 30 CIELAB units or more (Machado et al. 2009).
constexpr Rgb8 kHit{0, 45, 95};           // dark blue
constexpr Rgb8 kMissed{240, 185, 20};     // yellow
constexpr Rgb8 kSpurious{215, 100, 140};  // pink
constexpr Rgb8 kRelaxed{165, 60, 255};    // violet
constexpr Rgb8 kLit{255, 255, 255};
constexpr Rgb8 kNatural{195, 200, 205};  // shadow that does not count
constexpr Rgb8 kBorder{140, 140, 140};   // of the window

Rgb8 colour_of(bool cast, const ShadowImage& image, std::size_t cell) {
    const bool counts = image.window.empty() || image.window[cell];
    if (!counts) return cast ? kNatural : kLit;
    if (!image.relaxed.empty() && image.relaxed[cell]) return kRelaxed;
    const bool wanted = image.target[cell] != 0;
    if (cast) return wanted ? kHit : kSpurious;
    return wanted ? kMissed : kLit;
}

// Whether a sample lies at the inner side of the window's border.
bool on_border(const Field<std::uint8_t>& window, int x, int y, int rays) {
    if (window.empty() || !window(x / rays, y / rays)) return false;
    const auto outside = [&](int i, int j) {
        if (i < 0 || j < 0) return false;
        i /= rays, j /= rays;
        return window.contains(i, j) && !window(i, j);
    };
    return outside(x - 1, y) || outside(x + 1, y) || outside(x, y - 1) ||
           outside(x, y + 1);
}

}  // namespace

Field<Rgb8> overlay(const Field<std::uint8_t>& cast, const ShadowImage& image,
                    const Field<float>& relief) {
    const int rays = rays_of(cast, image.target);
    Field<Rgb8> result(cast.width(), cast.height());
    for (int y = 0; y < cast.height(); ++y)
        for (int x = 0; x < cast.width(); ++x) {
            const std::size_t cell = image.target.index(x / rays, y / rays);
            Rgb8 colour = colour_of(cast(x, y) != 0, image, cell);
            if (colour == kLit && on_border(image.window, x, y, rays)) colour = kBorder;
            const double light = 0.8 + 0.2 * relief[cell];
            for (int i = 0; i < 3; ++i)
                result(x, y)[i] = static_cast<std::uint8_t>(light * colour[i]);
        }
    return result;
}

}  // namespace cydonia::render
