// Why not Assimp's exporters (5.2): the normals of its STL are means over the triangles
// that share a corner, its glTF declares extensions that nothing in it uses, and a grid
// of 1024 x 1024 takes its OBJ 11 s and 1.1 GB. It reads these files back in the tests.
#include "field/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstring>
#include <iterator>

#include "field/vec.h"

namespace cydonia {
namespace {

// As it lies in memory: every processor we build for is little-endian, as are the
// formats.
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

std::array<float, 3> in_gltf(const std::array<float, 3>& v) {
    return {v[0] / 1000.0f, v[2] / 1000.0f, -v[1] / 1000.0f};
}

// Khronos, glTF 2.0 specification, sections 3.6 (accessors) and 4 (GLB). Without normals
// it is shaded flat (section 3.7.2.1), as the triangles are.
std::string glb_of(const Mesh& mesh) {
    std::array<float, 3> low = in_gltf(mesh.vertices.front()), high = low;
    for (const auto& vertex : mesh.vertices) {
        const auto v = in_gltf(vertex);
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], v[k]);
            high[k] = std::max(high[k], v[k]);
        }
    }
    const std::uint32_t vertex_bytes = 12 * count_of(mesh.vertices);
    const std::uint32_t index_bytes = 12 * count_of(mesh.triangles);
    std::string json = fmt::format(
        R"({{"asset":{{"version":"2.0","generator":"Cydonia"}},"scene":0,)"
        R"("scenes":[{{"nodes":[0]}}],"nodes":[{{"name":"land","mesh":0}}],)"
        R"("materials":[{{"pbrMetallicRoughness":{{"baseColorFactor":[0.8,0.8,0.8,1],)"
        R"("metallicFactor":0,"roughnessFactor":1}}}}],)"
        R"("meshes":[{{"name":"land","primitives":[{{"attributes":{{"POSITION":0}},)"
        R"("indices":1,"material":0}}]}}],)"
        R"("buffers":[{{"byteLength":{}}}],)"
        R"("bufferViews":[{{"buffer":0,"byteLength":{},"target":34962}},)"
        R"({{"buffer":0,"byteOffset":{},"byteLength":{},"target":34963}}],)"
        R"("accessors":[{{"bufferView":0,"componentType":5126,"type":"VEC3","count":{},)"
        R"("min":[{}],"max":[{}]}},)"
        R"({{"bufferView":1,"componentType":5125,"type":"SCALAR","count":{}}}]}})",
        vertex_bytes + index_bytes, vertex_bytes, vertex_bytes, index_bytes,
        mesh.vertices.size(), fmt::join(low, ","), fmt::join(high, ","),
        3 * mesh.triangles.size());
    json.resize((json.size() + 3) / 4 * 4, ' ');

    std::string bytes;
    const std::uint32_t whole =
        28 + static_cast<std::uint32_t>(json.size()) + vertex_bytes + index_bytes;
    bytes.reserve(whole);
    bytes += "glTF";
    append(bytes, std::uint32_t{2});
    append(bytes, whole);
    append(bytes, static_cast<std::uint32_t>(json.size()));
    bytes += "JSON";
    bytes += json;
    append(bytes, vertex_bytes + index_bytes);
    bytes += std::string_view("BIN\0", 4);
    for (const auto& vertex : mesh.vertices) append(bytes, in_gltf(vertex));
    for (const auto& triangle : mesh.triangles) append(bytes, triangle);
    return bytes;
}

}  // namespace

std::string_view name_of(MeshFormat format) {
    constexpr std::array<std::string_view, 4> kNames = {"stl", "obj", "ply", "glb"};
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
            return ply_of(mesh);
        case MeshFormat::kGlb:
            break;
    }
    return glb_of(mesh);
}

}  // namespace cydonia
