#include "synth/statistics/similarity.h"

#include <algorithm>
#include <cmath>

namespace cydonia::statistics {
namespace {

// The least deviation, for references that are equal but for rounding.
constexpr double kLeastDeviation = 1e-6;

std::array<double, 4> values_of(const Statistics& s) {
    return {s.mean, s.deviation, s.skewness, s.kurtosis};
}

// Edges, ridges, valleys and peaks all describe where and how often land bends. Together
// they have the weight of one other quantity, so that they do not dominate.
double weight_of(int quantity) {
    return quantity < int(Quantity::kEdgeScale) ? 1.0 : 0.25;
}

double sum_of(const std::array<double, 4>& values) {
    return values[0] + values[1] + values[2] + values[3];
}

}  // namespace

double Curve::operator()(double value) const {
    const double d = value - mean;
    if (d == 0.0) return 1.0;
    return deviation > 0.0 ? std::exp(-0.5 * d * d / (deviation * deviation)) : 0.0;
}

Curve curve_of(const std::vector<double>& references) {
    Curve curve;
    for (const double value : references) curve.mean += value;
    if (!references.empty()) curve.mean /= double(references.size());
    for (const double value : references)
        curve.deviation =
            std::max(curve.deviation, std::abs(value - curve.mean) /
                                          std::sqrt(-2.0 * std::log(kBaseline)));
    if (references.size() > 1)
        curve.deviation =
            std::max(curve.deviation, kLeastDeviation * std::abs(curve.mean) + 1e-12);
    return curve;
}

Library::Library(std::vector<Type> types) : types_(std::move(types)) {
    curves_.resize(types_.size());
    for (int q = 0; q < kQuantities; ++q)
        for (std::size_t s = 0; s < kStatistics; ++s) {
            const auto quantity = std::size_t(q);
            std::vector<double> all;
            double sum = 0.0;
            int known = 0;
            for (std::size_t t = 0; t < types_.size(); ++t) {
                std::vector<double> own;
                for (const Analysis& example : types_[t].examples)
                    if (example[quantity].count > 0)
                        own.push_back(values_of(example[quantity])[s]);
                std::ranges::copy(own, std::back_inserter(all));
                Curve& curve = curves_[t][quantity][s] = curve_of(own);
                if (own.size() > 1) sum += curve.deviation, ++known;
            }
            whole_[quantity][s] = curve_of(all);
            // A single example does not show how much examples of its type vary. It is
            // given the mean deviation of the other types, or a quarter of the library's
            // where they have none.
            const double usual =
                known > 0 ? sum / known : 0.25 * whole_[quantity][s].deviation;
            for (Curves& curves : curves_)
                if (!(curves[quantity][s].deviation > 0.0))
                    curves[quantity][s].deviation = usual;
        }
}

std::array<double, Library::kStatistics> Library::agreements(std::size_t type,
                                                             int quantity) const {
    std::array<double, kStatistics> all{};
    for (std::size_t s = 0; s < kStatistics; ++s) {
        const double own = curves_[type][std::size_t(quantity)][s].deviation,
                     whole = whole_[std::size_t(quantity)][s].deviation;
        // The similarity by eq. IV.8.
        all[s] = whole > 0.0 ? std::max(0.0, 1.0 - own * own / (whole * whole)) : 0.0;
    }
    return all;
}

double Library::agreement(std::size_t type, Quantity quantity) const {
    return sum_of(agreements(type, int(quantity))) / kStatistics;
}

Likeness Library::likeness(std::size_t type, Quantity quantity,
                           const Analysis& land) const {
    const auto q = std::size_t(quantity);
    if (types_[type].examples.empty() || land[q].count == 0) return {};
    const std::array<double, kStatistics> agreed = agreements(type, int(quantity));
    const double sum = sum_of(agreed);
    const auto values = values_of(land[q]);
    double similarity = 0.0;
    for (std::size_t s = 0; s < kStatistics; ++s)
        similarity += (sum > 0.0 ? agreed[s] / sum : 1.0 / kStatistics) *
                      curves_[type][q][s](values[s]);
    return {similarity, sum / kStatistics};
}

double Library::similarity(std::size_t type, const Analysis& land) const {
    double similarity = 0.0, weights = 0.0, plain = 0.0, all = 0.0;
    for (int q = 0; q < kQuantities; ++q) {
        const Likeness one = likeness(type, Quantity(q), land);
        const double weight = weight_of(q);
        similarity += weight * one.agreement * one.similarity;
        weights += weight * one.agreement;
        plain += weight * one.similarity, all += weight;
    }
    return weights > 0.0 ? similarity / weights : plain / all;
}

Library Library::with(std::size_t type, const Analysis& land) const {
    std::vector<Type> types = types_;
    types[type].examples.push_back(land);
    return Library(std::move(types));
}

}  // namespace cydonia::statistics
