#include "render/things/placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "field/error.h"
#include "field/image.h"
#include "field/noise.h"
#include "field/parallel.h"
#include "field/random.h"
#include "field/sample.h"
#include "field/smoothstep.h"
#include "render/cameras/view.h"
#include "render/things/originals.h"

namespace cydonia::render {
namespace {

constexpr double kMostSquares = 32e6;  // of the lattice, for a kind and frame
constexpr double kLeastPixels = 1.0;   // things lower than this in the frame are left out
constexpr double kGroup = 12.0;  // distance between groups, in mean distances of things
constexpr double kTreeLine = 0.12;  // share of the relief over which things become rarer
constexpr double kBehind =
    12.0;  // shadows may enter the frame from this many heights outside

// Where on the land a kind stands, and how tall.
class Suitability {
  public:
    Suitability(const Terrain& terrain, const ThingOptions& options, double distance,
                int number, const std::optional<WaterOptions>& flood)
        : terrain_(terrain),
          options_(options),
          slope_(options.slope.value_or(habit_of(options.kind).slope)),
          group_(kGroup * distance),
          seed_(hash_of({key("things"), key("groups"), std::uint64_t(number)})) {
        if (flood) flood_ = flood->level.in(terrain.width());
        const auto [low, high] = std::ranges::minmax(terrain.heights);
        band_ = std::max(1.0, kTreeLine * (double(high) - low));
        if (options.from) from_ = options.from->in(terrain.width());
        if (options.to) to_ = options.to->in(terrain.width());
        if (!options.mask.empty()) {
            const auto mask = terrain.masks.find(options.mask);
            if (mask == terrain.masks.end()) {
                std::string known;
                for (const auto& [name, field] : terrain.masks)
                    known += (known.empty() ? "" : ", ") + name;
                throw bad_request("render.thing: no mask '{}': this land has {}",
                                  options.mask, known.empty() ? "none" : known);
            }
            mask_ = &mask->second;
        }
        if (options.map) map_ = read_grey(*options.map);
    }

    // The share of the lattice that is taken at a point, in cells.
    double at(double x, double y, double height) const {
        if (shows_image(x, y)) return 0.0;
        double share =
            1.0 - smoothstep(std::tan(slope_[0]), std::tan(slope_[1]), steepness(x, y));
        if (from_)
            share *= smoothstep(*from_ - 0.1 * band_, *from_ + 0.1 * band_, height);
        if (to_) share *= 1.0 - smoothstep(*to_ - band_, *to_, height);
        if (mask_) share *= bilinear(*mask_, x, y);
        if (!map_.empty())
            share *=
                bilinear(map_, (x + 0.5) / terrain_.heights.width() * map_.width() - 0.5,
                         (y + 0.5) / terrain_.heights.height() * map_.height() - 0.5);
        if (share <= 0.0 || is_wet(x, y, height)) return 0.0;
        const double e = x * terrain_.spacing / group_, n = y * terrain_.spacing / group_;
        const double grouped =
            smoothstep(-0.25, 0.2,
                       gradient_noise(e, n, seed_) +
                           0.5 * gradient_noise(3.1 * e, 3.1 * n, mix(seed_)));
        return share * (1.0 - options_.clumping + options_.clumping * grouped);
    }
    // The share of its full height that a thing has: less towards the tree line.
    double growth(double height) const {
        return to_ ? 1.0 - 0.65 * smoothstep(*to_ - band_, *to_, height) : 1.0;
    }

  private:
    double steepness(double x, double y) const {
        x = std::clamp(x, 0.5, terrain_.heights.width() - 1.5);
        y = std::clamp(y, 0.5, terrain_.heights.height() - 1.5);
        const auto h = [&](double dx, double dy) {
            return double(bilinear(terrain_.heights, x + dx, y + dy));
        };
        return std::hypot(h(0.5, 0) - h(-0.5, 0), h(0, 0.5) - h(0, -0.5)) /
               terrain_.spacing;
    }
    std::size_t nearest(double x, double y) const {
        const Field<float>& h = terrain_.heights;
        return h.index(std::clamp(int(std::lround(x)), 0, h.width() - 1),
                       std::clamp(int(std::lround(y)), 0, h.height() - 1));
    }
    bool shows_image(double x, double y) const {
        return !options_.in_image &&
               std::ranges::any_of(terrain_.shadows, [&](const ShadowImage& image) {
                   return image.window.empty() || image.window[nearest(x, y)] != 0;
               });
    }
    bool is_wet(double x, double y, double height) const {
        return height <= flood_ || water_depth(terrain_, nearest(x, y)) > 0.0f;
    }

    const Terrain& terrain_;
    const ThingOptions& options_;
    const std::array<double, 2> slope_;
    const double group_;
    const std::uint64_t seed_;
    double flood_ = -HUGE_VAL, band_ = 1.0;
    std::optional<double> from_, to_;
    const Field<float>* mask_ = nullptr;
    Field<float> map_;
};

// Tells whether a thing is in a camera's frame, or so near that its shadow may be.
class Frame {
  public:
    explicit Frame(const Camera& camera)
        : axes_(camera),
          perspective_(camera.projection == Camera::Projection::kPerspective),
          pixel_(pixel_side(camera)),
          half_(0.5 * camera.width * pixel_),
          aspect_(aspect(camera)) {}
    // The distance beyond which a thing of `height` is lower than a pixel.
    double reach(double height) const {
        if (perspective_) return height / (kLeastPixels * pixel_);
        const double diagonal = std::hypot(1.0, 1.0 / aspect_) * half_;
        return height >= kLeastPixels * pixel_ ? 1.05 * diagonal : 0.0;
    }
    bool holds(const Vec3& at, double height) const {
        const Vec3 seen = axes_(at);
        const double margin = kBehind * height;
        if (perspective_ && seen.z < -margin) return false;
        const double half = perspective_ ? half_ * std::max(seen.z, 0.0) : half_;
        return std::abs(seen.x) <= half + margin &&
               std::abs(seen.y) <= half / aspect_ + margin;
    }
    double distance(const Vec3& at) const {
        return perspective_ ? length(at - axes_.eye) : 1.0;
    }
    const Vec3& eye() const { return axes_.eye; }
    bool perspective() const { return perspective_; }

  private:
    CameraAxes axes_;
    bool perspective_;
    double pixel_, half_, aspect_;
};

struct Candidate {
    Thing thing;
    double rank;  // those with the lowest rank are kept
};

void keep_first(std::vector<Candidate>& all, std::size_t most) {
    if (all.size() <= most) return;
    const auto by_rank = [](const Candidate& a, const Candidate& b) {
        return std::tuple(a.rank, a.thing.foot.x, a.thing.foot.y) <
               std::tuple(b.rank, b.thing.foot.x, b.thing.foot.y);
    };
    std::ranges::nth_element(all, all.begin() + std::ptrdiff_t(most), by_rank);
    all.resize(most);
}

// One square of a lattice over the plane for each thing at full density, taken or not.
class Lattice {
  public:
    Lattice(const Terrain& terrain, const ThingOptions& options, double density,
            int number, const Frame& frame, const std::optional<WaterOptions>& flood)
        : terrain_(terrain),
          habit_(habit_of(options.kind)),
          size_(options.size.value_or(habit_.size)),
          apart_(1.0 / std::sqrt(density)),
          number_(number),
          frame_(frame),
          suitability_(terrain, options, apart_, number, flood) {}

    // Those in the frame, by squares from the south-west.
    std::vector<Candidate> candidates() const {
        const double reach =
            std::min(frame_.reach(size_[1]), 0.5 * std::sqrt(kMostSquares) * apart_);
        const Vec3 eye = frame_.eye();
        const std::int64_t west = square(std::max(0.0, eye.x - reach)),
                           east = square(std::min(terrain_.width(), eye.x + reach)),
                           south = square(std::max(0.0, eye.y - reach)),
                           north = square(std::min(terrain_.depth(), eye.y + reach));
        if (east < west || north < south) return {};
        std::vector<std::vector<Candidate>> rows(std::size_t(north - south + 1));
        parallel_for(int(rows.size()), 16, [&](int row) {
            for (std::int64_t i = west; i <= east; ++i)
                if (const auto found = candidate(i, south + row))
                    rows[std::size_t(row)].push_back(*found);
        });
        std::vector<Candidate> all;
        for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
        return all;
    }

  private:
    std::int64_t square(double metres) const {
        return std::int64_t(std::floor(metres / apart_));
    }

    std::optional<Candidate> candidate(std::int64_t i, std::int64_t j) const {
        std::uint64_t h = hash_of(
            {key("things"), std::uint64_t(number_), std::uint64_t(i), std::uint64_t(j)});
        const auto draw = [&] { return unit(h = mix(h)); };
        const double east = (double(i) + draw()) * apart_,
                     north = (double(j) + draw()) * apart_;
        if (east >= terrain_.width() || north >= terrain_.depth()) return std::nullopt;
        const double x = east / terrain_.spacing - 0.5;
        const double y = (terrain_.depth() - north) / terrain_.spacing - 0.5;
        const double ground = ground_at(terrain_, east, north);
        const Vec3 at{east, north, ground};
        if (!frame_.holds(at, size_[1])) return std::nullopt;
        if (draw() >= suitability_.at(x, y, ground)) return std::nullopt;
        // There are more low things than tall ones, since things grow and break.
        const double grown = std::pow(draw(), 1.4);
        const double height =
            (size_[0] + grown * (size_[1] - size_[0])) * suitability_.growth(ground);
        Candidate found;
        found.thing = {{east, north, ground - habit_.sunk * height},
                       float(height),
                       float(2.0 * std::numbers::pi * draw()),
                       std::uint8_t(h >> 60 & (kOriginals - 1))};
        const double distance = frame_.distance(at);
        if (frame_.perspective() && distance > frame_.reach(height)) return std::nullopt;
        // Nearby all stay. Farther off the same angle holds more of them, and as many
        // fewer stay.
        found.rank = distance * std::sqrt(draw()) / height;
        return found;
    }

    const Terrain& terrain_;
    const Habit& habit_;
    const std::array<double, 2> size_;
    const double apart_;  // metres from square to square
    const int number_;
    const Frame& frame_;
    const Suitability suitability_;
};

// Whether a crest hides the top of a thing from the eye; it never hides things near the
// eye.
bool is_hidden(const Terrain& terrain, const Vec3& eye, const Vec3& top) {
    constexpr int kSteps = 96;
    for (int i = 1; i < kSteps; ++i) {
        const Vec3 p = eye + double(i) / kSteps * (top - eye);
        if (ground_at(terrain, p.x, p.y) > p.z + terrain.spacing) return true;
    }
    return false;
}

void drop_hidden(std::vector<Candidate>& all, const Terrain& terrain, const Vec3& eye) {
    std::vector<char> hidden(all.size());
    parallel_for(int(all.size()), 256, [&](int i) {
        const Thing& thing = all[std::size_t(i)].thing;
        const Vec3 top{thing.foot.x, thing.foot.y, thing.foot.z + thing.height};
        hidden[std::size_t(i)] = is_hidden(terrain, eye, top);
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!hidden[i]) all[kept++] = all[i];
    all.resize(kept);
}

}  // namespace

std::vector<Thing> things_in_view(const Terrain& terrain, const ThingOptions& options,
                                  int number, const Camera& camera, std::size_t most,
                                  const std::optional<WaterOptions>& flood) {
    const double density = options.density.value_or(habit_of(options.kind).density) / 1e4;
    if (density <= 0.0) return {};
    const Frame frame(camera);
    std::vector<Candidate> all =
        Lattice(terrain, options, density, number, frame, flood).candidates();
    if (frame.perspective()) {
        keep_first(all, 8 * most);
        drop_hidden(all, terrain, frame.eye());
    }
    keep_first(all, most);
    std::ranges::sort(all, {}, [](const Candidate& c) {
        return std::pair(c.thing.foot.y, c.thing.foot.x);
    });
    std::vector<Thing> things;
    for (const Candidate& c : all) things.push_back(c.thing);
    return things;
}

}  // namespace cydonia::render
