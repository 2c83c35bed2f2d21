#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "field/vec.h"

namespace cydonia::render {

// A binary glTF file under construction (Khronos, glTF 2.0 specification, section 4.4):
// its JSON, and one buffer to which everything else is appended, aligned to four bytes.
class Glb {
  public:
    using Json = nlohmann::ordered_json;

    Json json = {{"asset", {{"version", "2.0"}, {"generator", "Cydonia"}}}};

    // Each returns the index of what it added. A vertex attribute has `width` floats a
    // vertex; its bounds are written too, as positions need them.
    int attribute(std::span<const float> values, int width);
    int indices(std::span<const std::uint32_t> values);
    int image(std::string_view bytes, const char* mime_type);
    int texture(int image);  // linear, mipmapped, not repeated
    // Appends to an array of the JSON, such as "nodes".
    int add(const char* array, Json item);

    std::string file();

  private:
    int view(std::string_view bytes, int target);  // target 0: none

    std::string buffer_;
};

// A point or vector (east, north, up) in glTF's axes: y up and north at -z.
constexpr Vec3 in_gltf(const Vec3& world) { return {world.x, world.z, -world.y}; }

// The rotation that turns x, y and z to these axes (right-handed, of length 1) as a
// quaternion with its real part last.
std::array<double, 4> rotation_to(const Vec3& x, const Vec3& y, const Vec3& z);

}  // namespace cydonia::render
