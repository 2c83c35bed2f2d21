#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cydonia {

// Triangles that share their vertices. Millimetres, x east, y north, z up;
// counter-clockwise seen from outside.
struct Mesh {
    std::vector<std::array<float, 3>> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

// Binary STL, OBJ and PLY keep the mesh's millimetres and z up; glTF (.glb) is in metres
// with y up and north at -z, as its specification asks.
enum class MeshFormat { kStl, kObj, kPly, kGlb };

// "stl": as the command line and the file's extension name it.
std::string_view name_of(MeshFormat format);

// What a file of the mesh holds, at most 50 bytes a triangle. It has triangles.
std::string file_of(const Mesh& mesh, MeshFormat format);

}  // namespace cydonia
