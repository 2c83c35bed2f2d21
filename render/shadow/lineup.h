#pragma once

#include <cstdint>
#include <memory>

#include "field/field.h"

namespace cydonia::render {

// Compares a cast shadow with a target and with twenty other silhouettes (distractors.h).
// Large shapes at one position are similar whatever they show. Therefore all are compared
// at 128 pixels along the longer side and high-pass filtered: a blur over a sixteenth of
// the shorter side is subtracted.
class Lineup {
  public:
    explicit Lineup(const Field<std::uint8_t>& target);
    ~Lineup();

    // How far a cast (a sample a cell, of the target's shape) stands out as the target:
    // its correlation with the target minus the mean of its correlations with the others,
    // in standard deviations of these. A perfect cast has 13 to 25 and chance is
    // within 2. It is 0 without any shadow.
    double standing_out(const Field<std::uint8_t>& cast) const;

  private:
    struct Seen;
    std::unique_ptr<Seen> seen_;
};

}  // namespace cydonia::render
