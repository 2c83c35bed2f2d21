#include "field/solid.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "field/error.h"
#include "field/image.h"
#include "field/quantise.h"

namespace cydonia {
namespace {

constexpr double kHighest = 10'000.0;  // millimetres

void expect_within(const char* name, double value, double low, double high,
                   const char* unit) {
    if (value >= low && value <= high) return;  // false for NaN
    throw bad_request("{}: {} is not between {} and {}{}", name, value, low, high, unit);
}

// The surface's outermost samples from the north-west one on, counter-clockwise as seen
// from above.
std::vector<std::uint32_t> border_of(const Field<float>& heights) {
    const int right = heights.width() - 1, bottom = heights.height() - 1;
    std::vector<std::uint32_t> border;
    const auto add = [&](int x, int y) {
        border.push_back(static_cast<std::uint32_t>(heights.index(x, y)));
    };
    for (int y = 0; y < bottom; ++y) add(0, y);
    for (int x = 0; x < right; ++x) add(x, bottom);
    for (int y = bottom; y > 0; --y) add(right, y);
    for (int x = right; x > 0; --x) add(x, 0);
    return border;
}

// Appends the walls below the surface's border, and the plate's underside as a fan about
// its middle.
void close(Mesh& mesh, const std::vector<std::uint32_t>& border, const Vec3& size) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto count = static_cast<std::uint32_t>(border.size());
    for (const std::uint32_t i : border) {
        const auto [x, y, z] = mesh.vertices[i];
        mesh.vertices.push_back({x, y, 0.0f});
    }
    mesh.vertices.push_back({float(size.x / 2.0), float(size.y / 2.0), 0.0f});
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t next = (i + 1) % count;
        const std::uint32_t a = first + i, b = first + next;
        mesh.triangles.push_back({a, b, border[next]});
        mesh.triangles.push_back({a, border[next], border[i]});
        mesh.triangles.push_back({b, a, first + count});
    }
}

}  // namespace

void expect_in_range(const SolidOptions& options) {
    expect_within("size", options.size, 1.0, 10'000.0, " mm");
    expect_within("base", options.base, 0.1, 1000.0, " mm");
    expect_within("scale-z", options.scale_z, 0.01, 100.0, "");
    expect_within("samples", options.samples, 2, kMostSolidSamples, "");
}

Solid solid_of(const Terrain& terrain, const SolidOptions& options) {
    expect_in_range(options);
    assert(terrain.heights.width() >= 2 && terrain.heights.height() >= 2);
    const Field<float> heights =
        at_most(heights_of(quantised(terrain.heights)), options.samples);
    const int width = heights.width(), height = heights.height();

    // The surface ends at the outermost samples, half a cell inside the land.
    const double east = terrain.width() * (width - 1) / width;  // metres
    const double north = terrain.depth() * (height - 1) / height;
    const double scale = options.size / std::max(east, north);
    const auto [low, high] = std::ranges::minmax(heights);
    const double rise = scale * options.scale_z;
    const Vec3 size{scale * east, scale * north,
                    options.base + rise * (double(high) - low)};
    if (!(size.z <= kHighest))
        throw bad_request("the solid would be {:.0f} mm high; lower size or scale-z",
                          size.z);

    Mesh mesh;
    mesh.vertices.reserve(heights.size() + 2 * std::size_t(width + height));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            mesh.vertices.push_back(
                {float(size.x * x / (width - 1)),
                 float(size.y * (height - 1 - y) / (height - 1)),
                 float(options.base + rise * (double(heights(x, y)) - low))});
        }
    }
    mesh.triangles = triangles_over(width, height);
    close(mesh, border_of(heights), size);
    return {std::move(mesh), size, scale, width, height};
}

Sun lamp_for(const Sun& sun, const SolidOptions& options) {
    return {sun.azimuth, std::atan(options.scale_z * std::tan(sun.elevation))};
}

}  // namespace cydonia
