#pragma once

#include <array>
#include <string>
#include <vector>

#include "synth/statistics/analysis.h"

namespace cydonia::statistics {

// Gaussian curve projection (Saunders 2006, section IV.3.2.2): 1 at the mean of the
// references, and at least kBaseline at each of them.
inline constexpr double kBaseline = 0.9;
struct Curve {
    double mean = 0.0, deviation = 0.0;
    double operator()(double value) const;  // eq. IV.5
};
Curve curve_of(const std::vector<double>& references);  // eq. IV.6

// How similar a land's distribution is to a type's, and how reliable that is.
struct Likeness {
    double similarity = 0.0;  // 0 to 1
    double agreement = 0.0;   // 0 to 1
};

struct Type {
    std::string name;
    std::vector<Analysis> examples;  // at one level of detail
    std::array<std::uint8_t, 3> colour{};
};

// Types of land described by examples, all at one level of detail.
class Library {
  public:
    // Nothing is similar to a type without examples.
    explicit Library(std::vector<Type> types);

    const std::vector<Type>& types() const { return types_; }
    // The likeness of a land to a type in one quantity (eq. IV.7 to IV.10).
    Likeness likeness(std::size_t type, Quantity quantity, const Analysis& land) const;
    // The similarity in all quantities (eq. IV.11 and IV.12). Those of features have the
    // weight of one quantity together.
    double similarity(std::size_t type, const Analysis& land) const;
    // The distribution agreement (eq. IV.10) of a type's examples.
    double agreement(std::size_t type, Quantity quantity) const;
    // This library with one more example.
    Library with(std::size_t type, const Analysis& land) const;

  private:
    static constexpr int kStatistics = 4;
    using Curves = std::array<std::array<Curve, kStatistics>, kQuantities>;

    std::array<double, kStatistics> agreements(std::size_t type, int quantity) const;

    std::vector<Type> types_;
    std::vector<Curves> curves_;
    Curves whole_;  // of all examples of all types
};

}  // namespace cydonia::statistics
