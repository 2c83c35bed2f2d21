#pragma once

#include <cstdint>
#include <memory>

#include "field/field.h"

namespace cydonia::render {

// A target among twenty other silhouettes (distractors.h): does a shadow show this one?
// Large shapes at one place are alike whatever they show, so all are compared as seen
// from afar and without what is broad: at 128 pixels along the longer side, less their
// blur by a sixteenth of the shorter side.
class Lineup {
  public:
    explicit Lineup(const Field<std::uint8_t>& target);
    ~Lineup();

    // How far a cast (a sample a cell, shaped as the target) stands out as the target:
    // its correlation with it, less the mean of those with the others, in their standard
    // deviations. A perfect cast has 13 to 25; chance is within 2. 0 without any shadow.
    double standing_out(const Field<std::uint8_t>& cast) const;

  private:
    struct Seen;
    std::unique_ptr<Seen> seen_;
};

}  // namespace cydonia::render
