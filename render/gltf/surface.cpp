#include "render/gltf/surface.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "field/mesh.h"
#include "field/parallel.h"
#include "field/vec.h"
#include "render/gltf/glb.h"
#include "render/scene/water.h"

namespace cydonia::render {
namespace {

// Heights at the centres of the cells of a land of the given size.
struct Grid {
    const Field<float>& heights;
    double width, depth;  // metres

    Vec3 point(int x, int y) const {
        return {width * (x + 0.5) / heights.width(),
                depth * (1.0 - (y + 0.5) / heights.height()), heights(x, y)};
    }
    Vec3 normal(int x, int y) const {
        const Vec3 east =
            point(std::min(x + 1, heights.width() - 1), y) - point(std::max(x - 1, 0), y);
        const Vec3 north = point(x, std::max(y - 1, 0)) -
                           point(x, std::min(y + 1, heights.height() - 1));
        return normalized(cross(east, north));
    }
    // The normal at a point between samples, interpolated over its triangle.
    Vec3 normal_between(double x, double y) const {
        x = std::clamp(x, 0.0, heights.width() - 1.0);
        y = std::clamp(y, 0.0, heights.height() - 1.0);
        const int i = std::min(static_cast<int>(x), heights.width() - 2);
        const int j = std::min(static_cast<int>(y), heights.height() - 2);
        const double u = x - i, v = y - j;
        const Vec3 third = u > v ? normal(i + 1, j) : normal(i, j + 1);
        const double most = std::max(u, v), least = std::min(u, v);
        return normalized((1.0 - most) * normal(i, j) + (most - least) * third +
                          least * normal(i + 1, j + 1));
    }
};

// The direction in the surface that points east.
Vec3 tangent_of(const Vec3& normal) {
    const Vec3 east{1.0, 0.0, 0.0};
    return normalized(east - dot(east, normal) * normal);
}

void append(std::vector<float>& values, const Vec3& v) {
    for (const double component : {v.x, v.y, v.z})
        values.push_back(static_cast<float>(component));
}

Rgb8 pixel_of(const Vec3& normal) {
    const auto level = [](double v) {
        return static_cast<std::uint8_t>(std::lround(127.5 * (v + 1.0)));
    };
    return {level(normal.x), level(normal.y), level(normal.z)};
}

SurfaceMesh attributes_of(const Grid& grid) {
    SurfaceMesh s;
    const int width = grid.heights.width(), height = grid.heights.height();
    s.positions.reserve(3 * grid.heights.size());
    s.normals.reserve(3 * grid.heights.size());
    s.tangents.reserve(4 * grid.heights.size());
    s.places.reserve(2 * grid.heights.size());
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Vec3 normal = grid.normal(x, y);
            append(s.positions, in_gltf(grid.point(x, y)));
            append(s.normals, in_gltf(normal));
            append(s.tangents, in_gltf(tangent_of(normal)));
            s.tangents.push_back(1.0f);
            s.places.push_back(static_cast<float>((x + 0.5) / width));
            s.places.push_back(static_cast<float>((y + 0.5) / height));
        }
    }
    return s;
}

}  // namespace

SurfaceMesh surface_mesh(const Field<float>& heights, double width, double depth) {
    assert(heights.width() >= 2 && heights.height() >= 2);
    SurfaceMesh s = attributes_of({heights, width, depth});
    for (const auto& triangle : triangles_over(heights.width(), heights.height()))
        s.indices.insert(s.indices.end(), triangle.begin(), triangle.end());
    return s;
}

SurfaceMesh water_mesh(const Terrain& terrain, double width, double depth) {
    const auto water = water_surface(terrain);
    if (!water) return {};
    const Field<float> heights = heights_of(water->heights);
    SurfaceMesh s = attributes_of({heights, width, depth});
    const auto is_wet = [&](std::uint32_t i) { return water->heights.levels[i] > 0; };
    for (const auto& triangle : triangles_over(heights.width(), heights.height()))
        if (std::ranges::all_of(triangle, is_wet))
            s.indices.insert(s.indices.end(), triangle.begin(), triangle.end());
    return s.indices.empty() ? SurfaceMesh{} : s;
}

Field<Rgb8> normal_map(const Field<float>& fine, const Field<float>& coarse, double width,
                       double depth) {
    const Grid land{fine, width, depth}, mesh{coarse, width, depth};
    Field<Rgb8> map(fine.width(), fine.height());
    parallel_for(fine.height(), 8, [&](int y) {
        const double row = (y + 0.5) * coarse.height() / fine.height() - 0.5;
        for (int x = 0; x < fine.width(); ++x) {
            const double column = (x + 0.5) * coarse.width() / fine.width() - 0.5;
            const Vec3 up = mesh.normal_between(column, row);
            const Vec3 east = tangent_of(up), north = cross(up, east);
            const Vec3 normal = land.normal(x, y);
            map(x, y) =
                pixel_of({dot(normal, east), dot(normal, north), dot(normal, up)});
        }
    });
    return map;
}

}  // namespace cydonia::render
