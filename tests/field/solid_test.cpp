// Land as a solid: what must be true of it, and what Assimp reads from its files.
#include "field/solid.h"

#include <gtest/gtest.h>

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <random>

#include "field/error.h"

using namespace cydonia;

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// Rough land whose north-eastern corner is high.
Terrain rough(int width, int height) {
    Terrain terrain{Field<float>(width, height), 10.0, {}, {}, {}};
    std::mt19937 random(1);
    for (float& h : terrain.heights) h = float(random() % 1000) / 10.0f;
    terrain.heights(width - 1, 0) = 150.0f;
    return terrain;
}

// How often each directed edge occurs.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges_of(const Triangles& all) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& t : all) {
        for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    }
    return edges;
}

void expect_closed(const Triangles& triangles) {
    for (const auto& [edge, count] : edges_of(triangles)) {
        ASSERT_EQ(count, 1) << edge.first << "-" << edge.second;
    }
    const auto edges = edges_of(triangles);
    for (const auto& [edge, count] : edges) {
        ASSERT_TRUE(edges.contains({edge.second, edge.first}))
            << "open at " << edge.first << "-" << edge.second;
    }
}

// The volume by the divergence theorem. It is positive when the triangles face outwards.
double volume(const Mesh& mesh) {
    double sum = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        sum += dot(vec3_of(mesh.vertices[a]),
                   cross(vec3_of(mesh.vertices[b]), vec3_of(mesh.vertices[c])));
    }
    return sum / 6.0;
}

// The volume of prisms over squares split NW-SE, and of the plate.
double volume_of_prisms(const Field<float>& heights, const SolidOptions& options) {
    const double low = *std::ranges::min_element(heights);
    const double metres = 10.0 * (std::max(heights.width(), heights.height()) - 1);
    const double scale = options.size / metres, step = 10.0 * scale;
    double sum = 0.0;
    for (int y = 0; y + 1 < heights.height(); ++y) {
        for (int x = 0; x + 1 < heights.width(); ++x) {
            const double diagonal = double(heights(x, y)) + heights(x + 1, y + 1);
            const double others = double(heights(x, y + 1)) + heights(x + 1, y);
            const double mean = (2.0 * diagonal + others) / 6.0 - low;
            sum += step * step * (options.base + scale * options.scale_z * mean);
        }
    }
    return sum;
}

struct Bounds {
    Vec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
};
Bounds bounds_of(const Mesh& mesh) {
    Bounds b;
    for (const auto& v : mesh.vertices) {
        b.low = {std::min(b.low.x, double(v[0])), std::min(b.low.y, double(v[1])),
                 std::min(b.low.z, double(v[2]))};
        b.high = {std::max(b.high.x, double(v[0])), std::max(b.high.y, double(v[1])),
                  std::max(b.high.z, double(v[2]))};
    }
    return b;
}

// The mesh that Assimp reads from the bytes, with equal corners joined and z up.
Mesh read_back(const std::string& bytes, MeshFormat format) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFileFromMemory(
        bytes.data(), bytes.size(),
        aiProcess_JoinIdenticalVertices | aiProcess_DropNormals,
        std::string(name_of(format)).c_str());
    if (!scene || scene->mNumMeshes != 1)
        throw std::runtime_error(importer.GetErrorString());
    const aiMesh& read = *scene->mMeshes[0];
    Mesh mesh;
    for (unsigned i = 0; i < read.mNumVertices; ++i) {
        const aiVector3D v = read.mVertices[i];
        mesh.vertices.push_back({v.x, v.y, v.z});
    }
    for (unsigned i = 0; i < read.mNumFaces; ++i) {
        const aiFace& face = read.mFaces[i];
        if (face.mNumIndices != 3) throw std::runtime_error("not a triangle");
        mesh.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
    }
    return mesh;
}

template <class T>
T at(const std::string& bytes, std::size_t offset) {
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

}  // namespace

TEST(Solid, IsClosedAndOnePiece) {
    for (const auto& [width, height] : {std::pair{2, 2}, {9, 7}, {3, 40}, {40, 2}}) {
        const Solid solid = solid_of(rough(width, height), {});
        expect_closed(solid.mesh.triangles);
        const auto vertices = static_cast<std::ptrdiff_t>(solid.mesh.vertices.size());
        const auto faces = static_cast<std::ptrdiff_t>(solid.mesh.triangles.size());
        EXPECT_EQ(vertices - 3 * faces / 2 + faces, 2);  // Euler
    }
}

TEST(Solid, NoTwoVerticesFallTogetherAndNoTriangleIsAPoint) {
    const Solid solid = solid_of(rough(30, 20), {.size = 1.0, .base = 0.1});
    auto vertices = solid.mesh.vertices;
    std::ranges::sort(vertices);
    EXPECT_EQ(std::ranges::adjacent_find(vertices), vertices.end());
    for (const auto& [a, b, c] : solid.mesh.triangles) {
        const auto& v = solid.mesh.vertices;
        EXPECT_GT(
            length(cross(vec3_of(v[b]) - vec3_of(v[a]), vec3_of(v[c]) - vec3_of(v[a]))),
            1e-6);
    }
}

TEST(Solid, HoldsThePrismsUnderItsSurface) {
    const SolidOptions options{.size = 80.0, .base = 2.0, .scale_z = 1.5};
    const Terrain terrain = rough(24, 17);
    const double expected = volume_of_prisms(terrain.heights, options);
    EXPECT_NEAR(volume(solid_of(terrain, options).mesh), expected, 1e-4 * expected);
}

TEST(Solid, FacesOutward) {
    const Solid solid = solid_of(rough(12, 9), {.base = 2.0});
    const auto& v = solid.mesh.vertices;
    const auto& s = solid.size;
    int up = 0, down = 0, sides = 0;
    for (const auto& [a, b, c] : solid.mesh.triangles) {
        const Vec3 n = normalized(
            cross(vec3_of(v[b]) - vec3_of(v[a]), vec3_of(v[c]) - vec3_of(v[a])));
        const Vec3 middle = (1.0 / 3.0) * (vec3_of(v[a]) + vec3_of(v[b]) + vec3_of(v[c]));
        if (middle.z == 0.0) {
            ++down;
            EXPECT_EQ(n, (Vec3{0.0, 0.0, -1.0}));
        } else if (std::abs(n.z) < 1e-6) {
            ++sides;
            EXPECT_GT(dot(n, middle - Vec3{s.x / 2.0, s.y / 2.0, middle.z}), 0.0);
        } else {
            ++up;
            EXPECT_GT(n.z, 0.0);
        }
    }
    const int border = 2 * (11 + 8);
    EXPECT_EQ(up, 2 * 11 * 8);
    EXPECT_EQ(sides, 2 * border);
    EXPECT_EQ(down, border);
}

TEST(Solid, HasTheSizeAndThePlateThatWereAsked) {
    const SolidOptions options{.size = 120.0, .base = 4.0, .scale_z = 2.0};
    const Solid solid = solid_of(rough(31, 16), options);
    const Bounds b = bounds_of(solid.mesh);
    EXPECT_EQ(b.low, (Vec3{0.0, 0.0, 0.0}));
    EXPECT_NEAR(b.high.x, 120.0, 1e-4);
    EXPECT_NEAR(b.high.y, 60.0, 1e-4);
    // 300 m of mesh on 120 mm; from the lowest ground to 150 m, twice as high.
    EXPECT_NEAR(solid.millimetres_a_metre, 0.4, 1e-9);
    const Terrain land = rough(31, 16);
    const double relief = 150.0 - *std::ranges::min_element(land.heights);
    EXPECT_NEAR(b.high.z, 4.0 + relief * 0.4 * 2.0, 1e-3);
    EXPECT_NEAR(solid.size.z, b.high.z, 1e-4);
    float lowest_ground = 1e9f;
    for (int i = 0; i < 31 * 16; ++i)
        lowest_ground = std::min(lowest_ground, solid.mesh.vertices[std::size_t(i)][2]);
    EXPECT_FLOAT_EQ(lowest_ground, 4.0f);
}

TEST(Solid, NorthStaysNorthAndEastStaysEast) {
    const Solid solid = solid_of(rough(20, 10), {});
    const auto& v = *std::ranges::max_element(
        solid.mesh.vertices, {}, [](const auto& vertex) { return vertex[2]; });
    EXPECT_NEAR(v[0], solid.size.x, 1e-4);
    EXPECT_NEAR(v[1], solid.size.y, 1e-4);
}

TEST(Solid, LandOfMoreSamplesIsTheSameThingInLessDetail) {
    Terrain cone{Field<float>(200, 100), 5.0, {}, {}, {}};
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 200; ++x)
            cone.heights(x, y) = -float(std::hypot(x - 140.0, y - 20.0));
    }
    const Solid fine = solid_of(cone, {}), coarse = solid_of(cone, {.samples = 33});
    EXPECT_EQ(fine.width, 200);
    EXPECT_EQ(coarse.width, 33);
    EXPECT_EQ(coarse.height, 17);
    expect_closed(coarse.mesh.triangles);
    EXPECT_NEAR(coarse.size.x, 150.0, 1e-9);
    EXPECT_NEAR(coarse.size.y, fine.size.y, 0.03 * fine.size.y);
    EXPECT_NEAR(volume(coarse.mesh), volume(fine.mesh), 0.05 * volume(fine.mesh));
}

TEST(Solid, TheBedOfWater) {
    Terrain terrain = rough(8, 8);
    const Solid dry = solid_of(terrain, {});
    terrain.water = Field<float>(8, 8, 500.0f);
    EXPECT_EQ(solid_of(terrain, {}).mesh.vertices, dry.mesh.vertices);
}

TEST(Solid, FlatLandIsAPlate) {
    const Terrain flat{Field<float>(16, 16, 3.0f), 10.0, {}, {}, {}};
    const Solid solid = solid_of(flat, {.base = 2.5});
    expect_closed(solid.mesh.triangles);
    EXPECT_NEAR(solid.size.z, 2.5, 1e-9);
    EXPECT_NEAR(volume(solid.mesh), 150.0 * 150.0 * 2.5, 1.0);
}

TEST(Solid, LampOfHigherHeightsStandsHigher) {
    const Sun sun{1.0, radians(25.0)};
    EXPECT_NEAR(lamp_for(sun, {}).elevation, sun.elevation, 1e-12);
    const Sun lamp = lamp_for(sun, {.scale_z = 2.0});
    EXPECT_EQ(lamp.azimuth, sun.azimuth);
    EXPECT_NEAR(std::tan(lamp.elevation), 2.0 * std::tan(sun.elevation), 1e-12);
}

TEST(Solid, RefusesWhatNobodyCanMake) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double size : {0.0, -5.0, 0.5, 1e5, nan})
        EXPECT_THROW(solid_of(rough(4, 4), {.size = size}), Error) << size;
    for (const double base : {0.0, -1.0, 1e4, nan})
        EXPECT_THROW(solid_of(rough(4, 4), {.base = base}), Error) << base;
    for (const double scale : {0.0, -1.0, 1e3, nan})
        EXPECT_THROW(solid_of(rough(4, 4), {.scale_z = scale}), Error) << scale;
    for (const int samples : {-1, 0, 1, 4096, 1 << 30})
        EXPECT_THROW(solid_of(rough(4, 4), {.samples = samples}), Error) << samples;

    Terrain needle = rough(4, 4);
    needle.heights(1, 1) = 9000.0f;
    EXPECT_THROW(solid_of(needle, {.size = 1000.0}), Error);
    EXPECT_NO_THROW(solid_of(needle, {.size = 10.0}));
}

// Another reader finds the same closed solid in every format.
TEST(MeshFiles, ReadBackByAssimp) {
    const Solid solid = solid_of(rough(40, 25), {});
    for (const MeshFormat format :
         {MeshFormat::kStl, MeshFormat::kObj, MeshFormat::kPly}) {
        SCOPED_TRACE(name_of(format));
        const Mesh read = read_back(file_of(solid.mesh, format), format);
        EXPECT_EQ(read.vertices.size(), solid.mesh.vertices.size());
        EXPECT_EQ(read.triangles.size(), solid.mesh.triangles.size());
        expect_closed(read.triangles);

        const Bounds b = bounds_of(read);
        EXPECT_LT(length(b.low), 1e-6);
        EXPECT_LT(length(b.high - solid.size), 1e-4);
        const double expected = volume(solid.mesh);
        EXPECT_NEAR(volume(read), expected, 1e-5 * expected);
        const auto& top = *std::ranges::max_element(
            read.vertices, {}, [](const auto& vertex) { return vertex[2]; });
        EXPECT_NEAR(top[0], solid.size.x, 1e-4);
        EXPECT_NEAR(top[1], solid.size.y, 1e-4);
    }
}

TEST(MeshFiles, StlIsOfTheSizeItSaysWithNormalsOfItsTriangles) {
    const Solid solid = solid_of(rough(6, 5), {});
    const std::string stl = file_of(solid.mesh, MeshFormat::kStl);
    const auto count = at<std::uint32_t>(stl, 80);
    EXPECT_EQ(count, solid.mesh.triangles.size());
    ASSERT_EQ(stl.size(), 84 + 50 * std::size_t(count));
    EXPECT_FALSE(stl.starts_with("solid"));  // readers would take it for text
    for (std::size_t i = 0; i < count; ++i) {
        const auto v = at<std::array<std::array<float, 3>, 4>>(stl, 84 + 50 * i);
        const Vec3 n =
            cross(vec3_of(v[2]) - vec3_of(v[1]), vec3_of(v[3]) - vec3_of(v[1]));
        EXPECT_LT(length(normalized(n) - vec3_of(v[0])), 1e-5);
    }
}
