// B. Rusnell, "Distance-based terrain synthesis" (2009), sections 3.2, 4.2.5 and A.2.

#include "synth/distance/costs.h"

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "field/image.h"
#include "field/noise.h"
#include "field/parallel.h"
#include "field/random.h"
#include "field/sample.h"
#include "field/strokes.h"
#include "field/svg.h"
#include "synth/distance/sides.h"

namespace cydonia::distance {
namespace {

using Kind = CostRule::Kind;
using Range = CostRange;

const double kUsual = thesis_units(20.0).fraction;  // of the width

double noise_cost(const NoiseOptions& noise, const Site& site, double x, double y) {
    // All groups share one seed, so that equal options give the same field.
    return noise.scale.in(site.width) *
           noise_at(noise, x / site.width, y / site.width,
                    hash_of({site.seed, key("generator cost")}));
}

// The range over the land, measured on a lattice of 256 points along the longer side, so
// that it does not depend on the number of samples.
Range noise_range(const NoiseOptions& noise, const Site& site) {
    const int columns = (site.columns + 3) / 4, rows = (site.rows + 3) / 4;
    Field<float> values(columns, rows);
    parallel_for(rows, [&](int y) {
        for (int x = 0; x < columns; ++x) {
            values(x, y) = static_cast<float>(noise_cost(noise, site,
                                                         (x + 0.5) / columns * site.width,
                                                         (y + 0.5) / rows * site.depth));
        }
    });
    const auto [least, greatest] = std::ranges::minmax(values);
    return {least, greatest};
}

Range known_noise_range(const NoiseOptions& noise, const Site& site, NoiseRanges& known) {
    for (const auto& [options, range] : known) {
        if (options == noise) return range;
    }
    return known.emplace_back(noise, noise_range(noise, site)).second;
}

double farthest(const CostRule& rule, const Site& site) {
    const double x = rule.centre[0].in(site.width), y = rule.centre[1].in(site.width);
    return std::hypot(std::max(x, site.width - x), std::max(y, site.depth - y));
}

void check(const CostRule& rule, const std::string& group, const Site& site) {
    const auto refuse = [&](const char* what) {
        throw bad_request("group '{}': cost: {}", group, what);
    };
    if (rule.range && rule.share) refuse("give a range or a share, not both");
    if (!rule.share_of.empty() && !rule.share) refuse("share_of needs a share");
    if (rule.less != Length{} && !rule.share) refuse("less needs a share");
    if (rule.kind == Kind::kPainted && !rule.image) refuse("painted needs an image");
    if (rule.kind == Kind::kDrawn && rule.curve.empty()) refuse("drawn needs a curve");
    const bool combines = rule.kind == Kind::kMinimum || rule.kind == Kind::kSum;
    if (combines && rule.of.empty()) refuse("minimum and sum need rules in of");
    if (rule.kind == Kind::kNoise && !std::isfinite(noise_cost(rule.noise, site, 1, 1))) {
        refuse("the noise is not finite");
    }
}

}  // namespace

CostPattern::CostPattern(const CostRule& rule, const std::string& group, const Site& site,
                         Reference reference, NoiseRanges& noises, std::uint64_t purpose)
    : rule_(rule),
      site_(&site),
      group_(group),
      reference_(std::move(reference)),
      purpose_(purpose) {
    check(rule, group, site);
    switch (rule.kind) {
        case Kind::kNoise:
            own_ = known_noise_range(rule.noise, site, noises);
            break;
        case Kind::kTerrain: {
            const auto [low, high] = std::ranges::minmax(site.terrain.heights);
            own_ = {low, high};
            break;
        }
        case Kind::kPainted:
            painted_ = is_svg(*rule.image)
                           ? read_grey_at(*rule.image, site.columns, site.rows)
                           : read_grey(*rule.image);
            break;
        case Kind::kDrawn:
            drawn_ = unit_points_of(rule.curve, "group '" + group + "': cost");
            break;
        default:
            break;
    }
    for (const CostRule& part : rule.of) {
        of_.emplace_back(part, group, site, reference_, noises,
                         mix(purpose_ + of_.size() + 1));
    }
}

void CostPattern::enter(const Shape& shape, int i) {
    for (CostPattern& part : of_) part.enter(shape, i);
    if (rule_.kind == Kind::kRandom) {
        random_ = unit(hash_of({site_->seed, key("random cost"), key_of(group_), purpose_,
                                static_cast<std::uint64_t>(i)}));
    }
    if (rule_.kind == Kind::kDrawn) along_ = along(shape);
    if (rule_.kind == Kind::kGaussian) {
        double end = -1e300;
        begin_ = 1e300;
        for (const SitePoint& p : shape.places) {
            const double way =
                p.x * std::sin(rule_.azimuth) - p.y * std::cos(rule_.azimuth);
            begin_ = std::min(begin_, way);
            end = std::max(end, way);
        }
        deviation_ = 2.0 * (end - begin_) / 6.0;  // Rusnell 2009, eq. 4.2
    }

    source_ = raw_range();
    ends_ = {source_.least, source_.greatest};
    if (rule_.range) {
        ends_ = {(*rule_.range)[0].in(site_->width), (*rule_.range)[1].in(site_->width)};
    } else if (rule_.share) {
        // Rusnell 2009, eq. 4.1
        const double whole =
            rule_.share_of.empty() ? source_.greatest : reference_(rule_, shape);
        const double reference = std::max(0.0, whole - rule_.less.in(site_->width));
        ends_ = {(*rule_.share)[0] * reference, (*rule_.share)[1] * reference};
    }
}

Range CostPattern::raw_range() const {
    switch (rule_.kind) {
        case Kind::kNoise:
        case Kind::kTerrain:
            return {0.0, own_.greatest - own_.least};
        case Kind::kMinimum:
        case Kind::kSum: {
            Range range = of_.front().range();
            for (std::size_t i = 1; i < of_.size(); ++i) {
                const auto [least, greatest] = of_[i].range();
                if (rule_.kind == Kind::kSum) {
                    range = {range.least + least, range.greatest + greatest};
                } else {
                    range = {std::min(range.least, least),
                             std::min(range.greatest, greatest)};
                }
            }
            return range;
        }
        default:
            return {0.0, kUsual * site_->width};
    }
}

double CostPattern::raw(const SitePoint& place) const {
    const double usual = kUsual * site_->width;
    switch (rule_.kind) {
        case Kind::kNoise:
            return noise_cost(rule_.noise, *site_, place.x, place.y) - own_.least;
        case Kind::kTerrain:
            return own_.greatest - bilinear(site_->terrain.heights,
                                            place.x / site_->graph.spacing - 0.5,
                                            place.y / site_->graph.spacing - 0.5);
        case Kind::kRandom:
            return usual * random_;
        case Kind::kPainted:
            return usual * bilinear(painted_,
                                    place.x / site_->width * painted_.width() - 0.5,
                                    place.y / site_->depth * painted_.height() - 0.5);
        case Kind::kDrawn:
            return usual * drawn_share(along_[place.root]);
        case Kind::kGaussian: {
            const double way =
                place.x * std::sin(rule_.azimuth) - place.y * std::cos(rule_.azimuth);
            if (!(deviation_ > 0.0)) return usual;
            const double t = std::max(0.0, way - begin_) / deviation_;
            return usual * std::exp(-0.5 * t * t);
        }
        case Kind::kDistance:
            return usual *
                   std::hypot(place.x - rule_.centre[0].in(site_->width),
                              site_->depth - place.y - rule_.centre[1].in(site_->width)) /
                   farthest(rule_, *site_);
        case Kind::kMinimum: {
            double least = of_.front().at(place);
            for (const CostPattern& part : of_) least = std::min(least, part.at(place));
            return least;
        }
        case Kind::kSum: {
            double sum = 0.0;
            for (const CostPattern& part : of_) sum += part.at(place);
            return sum;
        }
    }
    return 0.0;
}

// The drawn curve's share: 0 at its top, 1 at its foot.
double CostPattern::drawn_share(double t) const {
    const auto after = std::ranges::upper_bound(drawn_, t, {}, &CurvePoint::x);
    if (after == drawn_.begin()) return 1.0 - drawn_.front().f;
    if (after == drawn_.end()) return 1.0 - drawn_.back().f;
    const CurvePoint& before = *(after - 1);
    return 1.0 - std::lerp(before.f, after->f, (t - before.x) / (after->x - before.x));
}

double CostPattern::at(const SitePoint& place) const {
    double value = raw(place);
    if (rule_.inverted) value = source_.least + source_.greatest - value;
    if (!rule_.range && !rule_.share) return value;
    const double size = source_.greatest - source_.least;
    const double share =
        size > 0.0 ? std::clamp((value - source_.least) / size, 0.0, 1.0) : 0.0;
    return std::lerp(ends_[0], ends_[1], share);
}

void set_costs(std::vector<Shape>& shapes, const Group& group, const Site& site,
               const CostPattern::Reference& reference, NoiseRanges& noises) {
    CostPattern pattern(group.cost, group.name, site, reference, noises);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        pattern.enter(shapes[i], static_cast<int>(i));
        for (std::vector<SitePoint>* places : {&shapes[i].places, &shapes[i].land}) {
            parallel_for(static_cast<int>(places->size()), 256, [&](int p) {
                SitePoint& place = (*places)[p];
                place.cost = static_cast<float>(std::max(0.0, pattern.at(place)));
            });
        }
    }
}

}  // namespace cydonia::distance
