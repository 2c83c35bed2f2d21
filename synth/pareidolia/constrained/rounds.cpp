#include "synth/pareidolia/constrained/rounds.h"

#include "synth/pareidolia/constrained/tighten.h"

namespace cydonia::pareidolia {
namespace {

constexpr int kRays = 2;  // a cell side
// Rounds continue while one leaves less than this share of the wrong samples.
constexpr double kWorthwhile = 0.97;
constexpr int kRounds = 8, kRoundIterations = 8;
// With several suns: how often cells that stay wrong are relaxed, and for how long the
// rest is then solved.
constexpr int kGivingRounds = 3, kGivingIterations = 24;

bool mostly_wrong(Part asked, const Field<std::uint8_t>& cast, int x, int y) {
    if (asked != Part::kLit && asked != Part::kShadow) return false;
    int dark = 0;
    for (int sample = 0; sample < kRays * kRays; ++sample)
        dark += cast(x * kRays + sample % kRays, y * kRays + sample / kRays);
    const int wrong = asked == Part::kLit ? dark : kRays * kRays - dark;
    return 2 * wrong > kRays * kRays;
}

}  // namespace

Rounds::Rounds(double spacing, const std::vector<Demand>& demands, const Context& context)
    : asked_(demands), demands_(demands), context_(context) {
    terrain_.spacing = spacing;
}

Field<float> Rounds::best_of(Bend& bend) {
    tightened(bend);
    for (int i = 0; i < kGivingRounds && demands_.size() > 1 && give_way(); ++i) {
        bend.demand(demands_);
        bend.run(kGivingIterations);
        tightened(bend);
    }
    return std::move(best_);
}

bool Rounds::gave_way(std::size_t image, int x, int y) const {
    return demands_[image].parts(x, y) == Part::kFree &&
           mostly_wrong(asked_[image].parts(x, y), best_casts_[image], x, y);
}

void Rounds::tightened(Bend& bend) {
    for (int round = 0;; ++round) {
        const std::size_t before = wrong_;
        cast(bend.heights());
        const bool helped = round == 0 || double(wrong_) < kWorthwhile * double(before);
        if (round == kRounds || !helped) return;
        for (std::size_t i = 0; i < demands_.size(); ++i) tighten(demands_[i], casts_[i]);
        bend.demand(demands_);
        bend.run(kRoundIterations);
    }
}

void Rounds::cast(Field<float> heights) {
    terrain_.heights = std::move(heights);
    casts_.clear();
    wrong_ = 0;
    for (const Demand& demand : asked_) {
        casts_.push_back(context_.cast(terrain_, demand.sun, kRays));
        wrong_ += wrong_in(demand, casts_.back()).all();
    }
    if (best_.empty() || wrong_ < least_) {
        least_ = wrong_;
        best_ = terrain_.heights;
        best_casts_ = casts_;
    }
}

bool Rounds::give_way() {
    bool any = false;
    for (std::size_t i = 0; i < demands_.size(); ++i)
        for (int y = 0; y < demands_[i].parts.height(); ++y)
            for (int x = 0; x < demands_[i].parts.width(); ++x) {
                Part& part = demands_[i].parts(x, y);
                if (!mostly_wrong(part, casts_[i], x, y)) continue;
                part = Part::kFree;
                any = true;
            }
    return any;
}

}  // namespace cydonia::pareidolia
