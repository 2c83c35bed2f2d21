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

// The triangles between width x height samples, whose row 0 is in the north. Each square
// is split NW-SE, and all triangles face up.
std::vector<std::array<std::uint32_t, 3>> triangles_over(int width, int height);

// Binary STL, OBJ and binary PLY.
enum class MeshFormat { kStl, kObj, kPly };

// The format's name on the command line and the file's extension, such as "stl".
std::string_view name_of(MeshFormat format);

// The bytes of a file of the mesh, at most 50 a triangle. The mesh must have triangles.
std::string file_of(const Mesh& mesh, MeshFormat format);

}  // namespace cydonia
