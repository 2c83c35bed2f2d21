// Why not Assimp's exporters (5.2): the normals of its STL are means over the triangles
// that share a corner, and a grid of 1024 x 1024 takes its OBJ 11 s and 1.1 GB. It reads
// these files back in the tests.
#include "field/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstring>
#include <iterator>

#include "field/vec.h"

namespace cydonia {
namespace {

// The bytes as they lie in memory: every processor that we build for is little-endian, as
// are the formats.
template <class T>
void append(std::string& bytes, const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::size_t at = bytes.size();
    bytes.resize(at + sizeof value);
    std::memcpy(bytes.data() + at, &value, sizeof value);
}

std::uint32_t count_of(const auto& items) {
    return static_cast<std::uint32_t>(items.size());
}

std::array<float, 3> normal_of(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
    const auto corner = [&](int i) {
        const auto& v = mesh.vertices[t[std::size_t(i)]];
        return Vec3{v[0], v[1], v[2]};
    };
    const Vec3 n = normalized(cross(corner(1) - corner(0), corner(2) - corner(0)));
    return {float(n.x), float(n.y), float(n.z)};
}

std::string stl_of(const Mesh& mesh) {
    std::string bytes = "Cydonia, millimetres, z up";
    bytes.reserve(84 + 50 * mesh.triangles.size());
    bytes.resize(80, ' ');
    append(bytes, count_of(mesh.triangles));
    for (const auto& triangle : mesh.triangles) {
        append(bytes, normal_of(mesh, triangle));
        for (const std::uint32_t i : triangle) append(bytes, mesh.vertices[i]);
        append(bytes, std::uint16_t{0});
    }
    return bytes;
}

std::string obj_of(const Mesh& mesh) {
    std::string text = "# Cydonia, millimetres, z up\n";
    text.reserve(40 * (mesh.vertices.size() + mesh.triangles.size()));
    const auto out = std::back_inserter(text);
    for (const auto& [x, y, z] : mesh.vertices)
        fmt::format_to(out, "v {} {} {}\n", x, y, z);
    for (const auto& [a, b, c] : mesh.triangles)
        fmt::format_to(out, "f {} {} {}\n", a + 1, b + 1, c + 1);
    return text;
}

std::string ply_of(const Mesh& mesh) {
    std::string bytes = fmt::format(
        "ply\nformat binary_little_endian 1.0\ncomment Cydonia, millimetres, z up\n"
        "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
        "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
        mesh.vertices.size(), mesh.triangles.size());
    bytes.reserve(bytes.size() + 12 * mesh.vertices.size() + 13 * mesh.triangles.size());
    for (const auto& vertex : mesh.vertices) append(bytes, vertex);
    for (const auto& triangle : mesh.triangles) {
        append(bytes, std::uint8_t{3});
        append(bytes, triangle);
    }
    return bytes;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangles_over(int width, int height) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangles.reserve(2 * std::size_t(width - 1) * std::size_t(height - 1));
    for (int y = 0; y + 1 < height; ++y) {
        for (int x = 0; x + 1 < width; ++x) {
            const auto nw = static_cast<std::uint32_t>(y * width + x);
            const auto sw = nw + static_cast<std::uint32_t>(width);
            triangles.push_back({nw, sw, sw + 1});
            triangles.push_back({nw, sw + 1, nw + 1});
        }
    }
    return triangles;
}

std::string_view name_of(MeshFormat format) {
    constexpr std::array<std::string_view, 3> kNames = {"stl", "obj", "ply"};
    return kNames[static_cast<std::size_t>(format)];
}

std::string file_of(const Mesh& mesh, MeshFormat format) {
    assert(!mesh.vertices.empty());
    switch (format) {
        case MeshFormat::kStl:
            return stl_of(mesh);
        case MeshFormat::kObj:
            return obj_of(mesh);
        case MeshFormat::kPly:
            break;
    }
    return ply_of(mesh);
}

}  // namespace cydonia
