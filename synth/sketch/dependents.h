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

// Which landform stands on which: a graph with an edge wherever a footprint lies over an
// earlier one (section 3.4).
class Stack {
  public:
    Stack(const Field<float>& land, const std::vector<Feature>& features);

    // `before`: the land without it.
    void add(std::size_t number, const std::vector<std::vector<Foot>>& feet,
             const Field<float>& before);
    // The uppermost landform over a sample; empty: none.
    const std::string& on_top(std::size_t sample) const;
    // The land as it is seen through landforms.
    Field<float> without(const Field<float>& land,
                         const std::vector<std::string>& names) const;
    // Says what stood on landforms that the last run had and this one has not, and keeps
    // the graph for the next.
    void compare(const Memory& memory, Progress& progress) const;

  private:
    struct Trace {  // of a landform that others are seen through
        std::vector<std::size_t> samples;
        std::vector<float> before;
    };
    const std::vector<Feature>& features_;
    Field<std::uint16_t> top_;  // number from 1 of the uppermost
    std::vector<std::vector<std::string>> stands_on_;
    std::map<std::string, Trace> traces_;
    std::vector<std::string> seen_through_;
};

}  // namespace cydonia::sketch
