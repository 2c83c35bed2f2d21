#pragma once

#include <cstdint>
#include <vector>

#include "render/embree/embree.h"
#include "render/things/originals.h"
#include "render/things/placement.h"

// Things on the ground for rays: instances of the originals that the .pov has, at the
// same places. For .cpp files alone.
namespace cydonia::render {

// A part of an original.
struct Shape {
    Original::Part part;
    std::vector<std::array<float, 3>> normals;  // at its corners; empty: it has edges
};

// Embree's space: metres about `middle`, over `unit`.
struct EmbreeSpace {
    Vec3 middle;
    double unit = 1.0;
};

class Copies {
  public:
    // `things` of each of the scene's kinds.
    Copies(const embree::Device& device, const std::vector<ThingOptions>& kinds,
           const std::vector<std::vector<Thing>>& things, const EmbreeSpace& space);

    bool empty() const { return copies_.empty(); }
    const embree::Scene& scene() const { return scene_; }

    struct Hit {
        std::uint8_t kind;   // of the scene's
        std::uint8_t shape;  // of shapes()
        Vec3 normal;         // in the world, of either side
    };
    Hit hit(unsigned instance, unsigned geometry, unsigned triangle, double u,
            double v) const;
    const std::vector<Shape>& shapes() const { return shapes_; }

  private:
    struct Copy {
        float turn;
        std::uint8_t kind, first_shape;
    };
    std::uint8_t add_original(const embree::Device& device, ThingOptions::Kind kind,
                              int number);

    std::vector<Shape> shapes_;
    std::vector<embree::Scene> originals_;
    std::vector<Copy> copies_;
    embree::Scene scene_;
};

}  // namespace cydonia::render
