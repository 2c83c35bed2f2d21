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

// Point and curve constraints, prepared for synthesis (section 5.1).
class Geometry {
  public:
    // `natural` is called for relative heights only. Warns where constraints contradict
    // each other and says which one is followed. Throws bad_request for constraints that
    // cannot be used.
    Geometry(const Options& options, const geometry::Ground& ground,
             const geometry::HeightAt& natural, Progress& progress);
    ~Geometry();

    bool empty() const;
    // What is asked of each cell of a window. It depends on the cell's position only.
    Field<Pull> pulls(const Window& window) const;

    // A place where the land must have a given height: every point, and positions along
    // every curve at most one cell of level 0 apart.
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
