#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "field/progress.h"
#include "synth/geometry/ground.h"
#include "synth/texture/constraints/guidance.h"
#include "synth/texture/options.h"

namespace cydonia::texture {

// Points and curves, ready to be asked (section 5.1).
class Geometry {
  public:
    // `natural` is asked for relative heights only. Warns of what contradicts itself, and
    // which won. Throws bad_request.
    Geometry(const Options& options, const Ground& ground, const HeightAt& natural,
             Progress& progress);
    ~Geometry();

    bool empty() const;
    // Row-major as in the window. Depends on each cell's place only.
    Field<Pull> pulls(const Window& window) const;

    // Where the land must have a height: along every curve at most one cell of level 0
    // apart, and at every point.
    struct Site {
        double x, y;     // metres from the south-west corner
        double height;   // metres
        int constraint;  // index in names()
    };
    const std::vector<Site>& sites() const;
    const std::vector<std::string>& names() const;  // points first

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace cydonia::texture
