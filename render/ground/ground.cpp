#include "render/ground/ground.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "field/parallel.h"
#include "field/random.h"
#include "field/rgb.h"
#include "field/sample.h"
#include "field/smoothstep.h"
#include "render/ground/relief.h"
#include "render/ground/texture_noise.h"

namespace cydonia::render {
namespace {

// Wet sand is about half as bright (Lekner and Dorf 1988).
constexpr double kWet = 0.45;

constexpr std::uint64_t kSeed = 0x6c616e64;

// The share of the bed's colour that water above it lets through (Beer-Lambert), down and
// up again.
constexpr Rgb kAbsorption{0.20f, 0.075f, 0.065f};  // a metre, of coastal water
Rgb seen_through(double depth, Rgb ground) {
    for (std::size_t c = 0; c < 3; ++c)
        ground[c] *= static_cast<float>(std::exp(-2.0 * depth * kAbsorption[c]));
    return ground;
}

Form between(const Form& a, const Form& b, double t) {
    const auto f = static_cast<float>(t);
    return {a.height + f * (b.height - a.height), a.slope + f * (b.slope - a.slope),
            a.north + f * (b.north - a.north),    a.hollow + f * (b.hollow - a.hollow),
            a.cavity + f * (b.cavity - a.cavity), a.wet + f * (b.wet - a.wet),
            a.shore + f * (b.shore - a.shore),    a.level + f * (b.level - a.level)};
}

Form bilinear(const Field<Form>& forms, double x, double y) {
    x = std::clamp(x, 0.0, forms.width() - 1.0);
    y = std::clamp(y, 0.0, forms.height() - 1.0);
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const int i1 = std::min(i + 1, forms.width() - 1);
    const int j1 = std::min(j + 1, forms.height() - 1);
    return between(between(forms(i, j), forms(i1, j), x - i),
                   between(forms(i, j1), forms(i1, j1), x - i), y - j);
}

// A scene's snow line and rock slope replace those of the look.
Look with_overrides(const GroundOptions& options, double width) {
    Look look = options.look;
    for (Layer& layer : look.layers) {
        if (options.snow_line && layer.role == Layer::Role::kSnow) {
            const double line = options.snow_line->in(width);
            layer.above = {{{line - 135.0, false}, {line + 135.0, false}}};
        }
        if (!options.rock_slope) continue;
        const auto [some, all] = *options.rock_slope;
        if (layer.role == Layer::Role::kRock)
            layer.slope = Ramp{some, std::max(all, some + 1e-6)};
        if (layer.role == Layer::Role::kScree)
            layer.slope = Ramp{0.67 * some, std::max(0.96 * some, 0.67 * some + 1e-6)};
    }
    return look;
}

// The noise at a point, shared by all borders and materials.
struct Point {
    double east, south;  // metres
    Form form;
    double wide, fine, finest;  // noise
};

class Painter {
  public:
    Painter(const Terrain& terrain, const GroundOptions& options, int detail)
        : terrain_(terrain),
          look_(with_overrides(options, terrain.width())),
          relief_(relief_of(terrain, uses_wetness(look_))),
          // Wavelengths: metres on land of kilometres, wider on wider land.
          wide_(std::min(std::max(200.0, terrain.width() / 75.0), terrain.width() / 4.0)),
          // Noise finer than two pixels would differ with the number of pixels.
          fine_(std::clamp(0.1 * wide_ * detail / terrain.spacing - 1.0, 0.0, 1.0)),
          finest_(std::clamp(0.035 * wide_ * detail / terrain.spacing - 1.0, 0.0, 1.0)) {
        for (const Layer& layer : look_.layers) masks_.push_back(mask_of(layer));
    }

    // The colour at a point of the grid, in cells, and the material with the largest
    // share.
    std::pair<Rgb, std::uint8_t> at(double x, double y) const {
        Point p{(x + 0.5) * terrain_.spacing,
                (y + 0.5) * terrain_.spacing,
                bilinear(relief_.forms, x, y),
                0.0,
                0.0,
                0.0};
        p.wide = texture_noise(p.east, p.south, wide_, kSeed);
        if (fine_ > 0.0)
            p.fine = fine_ * texture_noise(p.east, p.south, 0.1 * wide_, kSeed + 1);
        if (finest_ > 0.0)
            p.finest = finest_ * texture_noise(p.east, p.south, 0.035 * wide_, kSeed + 3);

        Rgb colour{};
        std::size_t top = 0;
        double of_top = 0.0;
        const double washed = relief_.water && look_.shore ? washed_at(p) : 0.0;
        for (std::size_t i = 0; i < look_.layers.size(); ++i) {
            const Layer& layer = look_.layers[i];
            double share = cover(i, p, x, y);
            if (layer.role == Layer::Role::kSnow) share *= 1.0 - washed;
            lay(layer.material, share, p, colour, top, of_top);
        }
        if (washed > 0.0) {
            const double rocky =
                smoothstep(radians(32.0), radians(42.0), double(p.form.slope));
            const double depth = p.form.level - p.form.height;
            lay(*look_.shore, washed * (1.0 - rocky), p, colour, top, of_top);
            if (look_.bed)
                lay(*look_.bed, washed * (1.0 - rocky) * smoothstep(2.0, 25.0, depth), p,
                    colour, top, of_top);
        }
        if (washed > 0.0) colour = (1.0 - kWet * wetted_at(p)) * colour;
        if (relief_.water && p.form.shore > 0.0f)
            colour = seen_through(std::max(0.0f, p.form.level - p.form.height), colour);
        return {colour, static_cast<std::uint8_t>(top)};
    }

  private:
    static bool uses_wetness(const Look& look) {
        return std::ranges::any_of(look.layers,
                                   [](const Layer& l) { return l.wet.has_value(); });
    }

    const Field<float>* mask_of(const Layer& layer) const {
        const auto found = terrain_.masks.find(layer.mask);
        return found == terrain_.masks.end() ? nullptr : &found->second;
    }

    void lay(std::size_t material, double share, const Point& p, Rgb& colour,
             std::size_t& top, double& of_top) const {
        if (share <= 0.0) return;
        colour = mixed(colour, colour_of(material, p), share);
        of_top *= 1.0 - share;
        if (share > of_top) top = material, of_top = share;
    }

    // How much a layer covers of what lies below it. The least fulfilled of its
    // conditions decides, and noise shifts the limit.
    double cover(std::size_t i, const Point& p, double x, double y) const {
        const Layer& layer = look_.layers[i];
        if (!layer.limited()) return layer.amount;
        const Form& f = p.form;
        double t = 1.5;
        const auto hold = [&t](double value) { t = std::min(t, value); };
        const auto along = [&](const std::optional<Ramp>& ramp, double value) {
            if (ramp) hold(ramp->at(value));
        };
        const auto beyond = [&](const std::array<Elevation, 2>& limits, double height) {
            hold(Ramp{limits[0].in(relief_.lowest, relief_.range),
                      limits[1].in(relief_.lowest, relief_.range)}
                     .at(height));
        };
        if (layer.above)
            beyond(*layer.above, f.height + layer.north_lowers * f.north +
                                     layer.hollow_lowers * f.hollow);
        if (layer.below) beyond(*layer.below, f.height);
        along(layer.slope, f.slope);
        along(layer.gentle, f.slope);
        along(layer.hollow, f.hollow);
        along(layer.wet, f.wet);
        along(layer.north, f.north);
        if (!layer.mask.empty()) hold(masks_[i] ? bilinear_mask(i, x, y) : -9.0);
        if (t < -0.8) return 0.0;
        if (layer.patches < 1.0) hold(patch(i, p));
        if (t < -0.8) return 0.0;
        t += 0.45 * texture_noise(p.east, p.south, wide_, kSeed + 100 + i) +
             0.3 * p.fine + 0.2 * p.finest;
        const double edge = std::max(0.5 * layer.soft, 0.01);
        return layer.amount * smoothstep(0.5 - edge, 0.5 + edge, t);
    }

    double bilinear_mask(std::size_t i, double x, double y) const {
        return cydonia::bilinear(*masks_[i], x, y);
    }

    // A value that is above one half in the share `patches` of the land; the noise is
    // distributed about logistically.
    double patch(std::size_t i, const Point& p) const {
        const Layer& layer = look_.layers[i];
        const double share = std::clamp(layer.patches, 0.001, 0.999);
        const double noise =
            texture_noise(p.east, p.south, layer.patch_size, kSeed + 200 + i);
        return 0.5 + 2.5 * (noise + 0.2 * std::log(share / (1.0 - share)));
    }

    // 1 under water and as far up as waves keep the ground wet.
    double wetted_at(const Point& p) const {
        const double above = p.form.height - p.form.level;
        return p.form.shore * smoothstep(1.8 + p.fine, 0.4 + p.fine, above);
    }

    // 1 where waves reach, 0 above.
    double washed_at(const Point& p) const {
        if (p.form.shore <= 0.0f) return 0.0;
        const double depth = p.form.level - p.form.height;
        return p.form.shore * smoothstep(-4.0 - 2.0 * p.wide - p.fine, 0.0, depth);
    }

    Rgb colour_of(std::size_t index, const Point& p) const {
        const Material& m = look_.materials[index];
        const double patches =
            texture_noise(p.east, p.south, m.variation, kSeed + 300 + 2 * index);
        // Darkens gullies, which hold dirt and damp, and not edges.
        double shade = 0.5 + 0.45 * patches + m.grain * (p.fine + 0.8 * p.finest) -
                       0.4 * p.form.cavity;
        Rgb light = m.light, dark = m.dark;
        double bedded = 0.0;
        Rgb bed{};
        if (m.strata) {
            const Strata& s = *m.strata;
            bedded =
                s.strength * smoothstep(s.slope[0], s.slope[1], double(p.form.slope));
            if (bedded > 0.0) bedded *= beds(s, p, shade, bed);
        }
        Rgb colour = mixed(dark, light, std::clamp(shade, 0.0, 1.0));
        if (bedded > 0.0 && !m.strata->colours.empty())
            colour =
                mixed(colour, (0.8 + 0.4 * std::clamp(shade, 0.0, 1.0)) * bed, bedded);
        if (m.tint) {
            const double share = std::clamp(m.tinted, 0.001, 0.999);
            const double n = texture_noise(p.east, p.south, 1.7 * m.variation,
                                           kSeed + 301 + 2 * index) +
                             0.2 * std::log(share / (1.0 - share)) + 0.2 * p.fine;
            colour = mixed(colour, *m.tint, smoothstep(-0.15, 0.35, n));
        }
        return colour;
    }

    // Beds of rock by height, thick and thin and slightly bent: how much they show, their
    // shade and the colour of the bed at this height.
    double beds(const Strata& s, const Point& p, double& shade, Rgb& colour) const {
        const double bend = 0.4 * texture_noise(p.east, p.south, 8.0 * wide_, kSeed + 2);
        const double at =
            p.form.height / s.thickness + bend + 0.12 * p.wide + 0.06 * p.fine;
        const double thin = unevenness(2.9 * at);
        shade += s.strength * (0.45 * unevenness(at) + 0.25 * thin);
        if (!s.colours.empty()) {
            const double floor = std::floor(at);
            const auto colour_at = [&](double bed) -> const Rgb& {
                return s.colours[mix(kSeed ^ static_cast<std::uint64_t>(
                                                 static_cast<std::int64_t>(bed))) %
                                 s.colours.size()];
            };
            colour = mixed(colour_at(floor), colour_at(floor + 1.0),
                           smoothstep(0.8, 1.0, at - floor));
        }
        return 0.45 + 0.55 * smoothstep(-0.5, 0.3, p.wide);
    }

    // One-dimensional value noise, -1 to 1.
    static double unevenness(double at) {
        const double floor = std::floor(at);
        const auto value = [](double i) {
            return signed_unit(
                mix(~kSeed ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(i))));
        };
        return std::lerp(value(floor), value(floor + 1.0),
                         smoothstep(0.2, 0.8, at - floor));
    }

    const Terrain& terrain_;
    Look look_;
    Relief relief_;
    double wide_, fine_, finest_;
    std::vector<const Field<float>*> masks_;
};

}  // namespace

GroundMap ground_map(const Terrain& terrain, const GroundOptions& options, int detail) {
    const Painter painter(terrain, options, detail);
    const int width = terrain.heights.width() * detail;
    const int height = terrain.heights.height() * detail;
    GroundMap map{Field<Rgb>(width, height), Field<std::uint8_t>(width, height)};
    parallel_for(height, 8, [&](int y) {
        for (int x = 0; x < width; ++x)
            std::tie(map.albedo(x, y), map.materials(x, y)) =
                painter.at((x + 0.5) / detail - 0.5, (y + 0.5) / detail - 0.5);
    });
    return map;
}

Field<Rgb> ground_albedo(const Terrain& terrain, const GroundOptions& options,
                         int detail) {
    return ground_map(terrain, options, detail).albedo;
}

}  // namespace cydonia::render
