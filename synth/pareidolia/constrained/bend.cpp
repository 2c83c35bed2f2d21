#include "synth/pareidolia/constrained/bend.h"

#include <algorithm>
#include <cmath>

#include "field/parallel.h"

namespace cydonia::pareidolia {
namespace {

// The penalty of the augmented Lagrangian, where the cost of slopes is one.
constexpr float kPull = 1.0f;
// Over-relaxation (Boyd et al. 2011, section 3.4.3).
constexpr float kOver = 1.7f;

// Calls body(i) for every cell, on all threads.
template <class Body>
void for_rows(const Field<float>& field, const Body& body) {
    parallel_for(field.height(), 64, [&](int y) {
        const std::size_t first = field.index(0, y);
        for (std::size_t i = first; i < first + field.width(); ++i) body(i);
    });
}

}  // namespace

Bend::Bend(Field<float> land, double spacing, double cells, Field<float> held,
           const BendOptions& options)
    : land_(std::move(land)),
      change_(land_.width(), land_.height()),
      spacing_(spacing),
      cells_(cells),
      held_(std::move(held)),
      held_dual_(held_.width(), held_.height()),
      options_(options) {}

void Bend::demand(const std::vector<Demand>& demands) {
    const Field<float> now = heights();
    for (std::size_t i = 0; i < demands.size(); ++i) {
        const Demand& demand = demands[i];
        if (i < sights_.size()) {
            sights_[i].records = records_of(demand, sights_[i].rows, cells_, spacing_);
            continue;
        }
        LightRows rows(land_.width(), land_.height(), demand.sun.azimuth, options_.stops);
        Records records = records_of(demand, rows, cells_, spacing_);
        Field<float> samples = rows.sampled(now), nearest = samples;
        Field<float> dual(samples.width(), samples.height()), excess = dual;
        sights_.push_back({std::move(rows), std::move(records), std::move(samples),
                           std::move(nearest), std::move(dual), std::move(excess)});
    }
}

Field<float> Bend::heights() const {
    Field<float> result = land_;
    for_rows(result, [&](std::size_t i) { result[i] += change_[i]; });
    return result;
}

void Bend::project(Sight& sight) const {
    constexpr int kBand = 16;
    parallel_for((sight.rows.rows() + kBand - 1) / kBand, [&](int band) {
        RecordsProjection nearest_to;
        const int end = std::min(sight.rows.rows(), (band + 1) * kBand);
        for (int row = band * kBand; row < end; ++row) {
            const auto [first, past] = sight.rows.span(row);
            const float* sample = sight.samples.row(row).data();
            float* nearest = sight.nearest.row(row).data();
            float* dual = sight.dual.row(row).data();
            float* excess = sight.excess.row(row).data();
            for (int i = first; i < past; ++i) {
                dual[i] += kOver * sample[i] + (1.0f - kOver) * nearest[i];
                nearest[i] = dual[i];
            }
            nearest_to(sight.records, row, first, past, nearest);
            for (int i = first; i < past; ++i) {
                dual[i] -= nearest[i];
                excess[i] = sample[i] - nearest[i] + dual[i];
            }
        }
    });
}

Field<float> Bend::force(float pull) const {
    Field<float> result = change_;
    for_rows(result, [&](std::size_t i) { result[i] *= pull; });
    for (const Sight& sight : sights_) {
        const Field<float> back = sight.rows.gathered(sight.excess);
        for_rows(result, [&](std::size_t i) { result[i] -= kPull * back[i]; });
    }
    for_rows(held_, [&](std::size_t i) {
        if (std::isfinite(held_[i]))
            result[i] -= kPull * (land_[i] + change_[i] - held_[i] + held_dual_[i]);
    });
    return result;
}

void Bend::hold() {
    for_rows(held_, [&](std::size_t i) {
        if (std::isfinite(held_[i])) held_dual_[i] += land_[i] + change_[i] - held_[i];
    });
}

void Bend::run(int iterations) {
    const float pull = kPull * static_cast<float>(sights_.size() + !held_.empty());
    const Membrane membrane(land_.width(), land_.height(), options_.stiffness, pull);
    for (int iteration = 0; iteration < iterations; ++iteration) {
        Field<float> solved = force(pull);
        membrane.solve(solved);
        change_ = std::move(solved);
        hold();
        const Field<float> now = heights();
        for (Sight& sight : sights_) {
            sight.samples = sight.rows.sampled(now);
            project(sight);
        }
    }
}

}  // namespace cydonia::pareidolia
