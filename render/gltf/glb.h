#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "field/vec.h"

namespace cydonia::render {

// A binary glTF file while it is put together (Khronos, glTF 2.0 specification, section
// 4.4): the JSON, and one buffer that everything else is appended to, each part on four
// bytes.
class Glb {
  public:
    using Json = nlohmann::ordered_json;

    Json json = {{"asset", {{"version", "2.0"}, {"generator", "Cydonia"}}}};

    // Each gives the index of what it added. Of a vertex attribute's floats, `width` a
    // vertex; its bounds are noted, as positions need.
    int attribute(std::span<const float> values, int width);
    int indices(std::span<const std::uint32_t> values);
    int image(std::string_view bytes, const char* mime_type);
    int texture(int image);  // linear, mipmapped, not repeated
    // To an array of the JSON: "nodes".
    int add(const char* array, Json item);

    std::string file();

  private:
    int view(std::string_view bytes, int target);  // 0: of no target

    std::string buffer_;
};

// Metres east, north and up in glTF's axes: y up, and north at -z.
constexpr Vec3 in_gltf(const Vec3& world) { return {world.x, world.z, -world.y}; }

// The rotation that takes x, y and z to these axes, of length 1 and right-handed: a
// quaternion, its real part last.
std::array<double, 4> rotation_to(const Vec3& x, const Vec3& y, const Vec3& z);

}  // namespace cydonia::render
