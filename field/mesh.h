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

// The triangles between width x height samples, row 0 in the north, each square split
// NW-SE and facing up.
std::vector<std::array<std::uint32_t, 3>> triangles_over(int width, int height);

// Binary STL, OBJ and binary PLY.
enum class MeshFormat { kStl, kObj, kPly };

// "stl": as the command line and the file's extension name it.
std::string_view name_of(MeshFormat format);

// What a file of the mesh holds, at most 50 bytes a triangle. It has triangles.
std::string file_of(const Mesh& mesh, MeshFormat format);

}  // namespace cydonia
