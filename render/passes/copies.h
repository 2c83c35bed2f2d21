#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "render/things/originals.h"
#include "render/things/placement.h"

// Things on the ground as geometry for rays: instances of the same originals at the same
// points as in the .pov.
struct RTCDeviceTy;  // Embree's
struct RTCSceneTy;

namespace cydonia::render {

// A part of an original.
struct Shape {
    Original::Part part;
    std::vector<std::array<float, 3>>
        normals;  // at its corners; empty when its faces are flat
};

// Embree's coordinates: (world metres - `middle`) / `unit`.
struct EmbreeSpace {
    Vec3 middle;
    double unit = 1.0;
};

class Copies {
  public:
    // `things` holds a list for each of the scene's kinds.
    Copies(RTCDeviceTy* device, const std::vector<ThingOptions>& kinds,
           const std::vector<std::vector<Thing>>& things, const EmbreeSpace& space);

    ~Copies();

    bool empty() const { return copies_.empty(); }
    RTCSceneTy* scene() const;  // instances

    struct Facet {
        std::uint8_t kind;   // of the scene's
        std::uint8_t shape;  // of shapes()
        Vec3 normal;         // in world space, towards either side
    };
    Facet facet(unsigned instance, unsigned geometry, unsigned triangle, double u,
                double v) const;
    const std::vector<Shape>& shapes() const { return shapes_; }

  private:
    struct Copy {
        float turn;
        std::uint8_t kind, first_shape;
    };
    struct Scenes;
    std::uint8_t add_original(RTCDeviceTy* device, ThingOptions::Kind kind, int number);

    std::vector<Shape> shapes_;
    std::vector<Copy> copies_;
    std::unique_ptr<Scenes> scenes_;
};

}  // namespace cydonia::render
