#pragma once

#include <map>
#include <string>
#include <vector>

#include "field/field.h"
#include "field/progress.h"
#include "synth/context.h"
#include "synth/sketch/footprint.h"
#include "synth/sketch/options.h"

namespace cydonia::sketch {

// The graph of which landform stands on which, with an edge wherever a footprint lies
// over an earlier one (section 3.4).
class Stack {
  public:
    Stack(const Field<float>& land, const std::vector<Feature>& features);

    // Adds feature `number`. `before` is the land without it.
    void add(std::size_t number, const std::vector<std::vector<Foot>>& feet,
             const Field<float>& before);
    // The uppermost landform over a sample; empty: none.
    const std::string& on_top(std::size_t sample) const;
    // The land without the named landforms, as it is seen through them.
    Field<float> without(const Field<float>& land,
                         const std::vector<std::string>& names) const;
    // Says which landforms stood on one that the last run had and this one does not have,
    // and stores the graph for the next run.
    void compare(const Memory& memory, Progress& progress) const;

  private:
    struct Trace {  // of a landform through which others are seen
        std::vector<std::size_t> samples;
        std::vector<float> before;
    };
    const std::vector<Feature>& features_;
    Field<std::uint16_t> top_;  // number of the uppermost, from 1; 0: none
    std::vector<std::vector<std::string>> stands_on_;
    std::map<std::string, Trace> traces_;
    std::vector<std::string> seen_through_;
};

}  // namespace cydonia::sketch
