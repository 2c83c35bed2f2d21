#include "render/passes/mesh.h"

#include <algorithm>
#include <cmath>

#include "field/quantise.h"

namespace cydonia::render {
namespace {

// A coordinate in cells from the land's middle, mapped from a copy back to the land.
struct Folded {
    double at;
    int mirrored;  // 1 or -1
};
Folded folded(double at, int samples) {
    const double land = std::nearbyint(at / (samples - 1));
    const int sign = std::fmod(land, 2.0) == 0.0 ? 1 : -1;
    return {sign * (at - land * (samples - 1)), sign};
}

}  // namespace

Mesh::Mesh(const Terrain& terrain) {
    terrain_.heights = heights_of(quantised(terrain.heights));
    terrain_.spacing = terrain.spacing;
}

bool Mesh::is_under(const Vec3& p, int lands) const {
    const double s = 0.5 * terrain_.spacing;
    // Neighbouring copies share the samples of their border.
    const double x = lands * (terrain_.width() - 2.0 * s);
    const double y = lands * (terrain_.depth() - 2.0 * s);
    return p.x >= s - x && p.y >= s - y && p.x <= terrain_.width() + x - s &&
           p.y <= terrain_.depth() + y - s;
}

Mesh::Spot Mesh::spot(double east, double north) const {
    const Field<float>& h = terrain_.heights;
    const int w = h.width(), d = h.height();
    const Folded column = folded(east / terrain_.spacing - 0.5 * w, w);
    const Folded row = folded(0.5 * d - north / terrain_.spacing, d);
    const double x = std::clamp(column.at + 0.5 * (w - 1), 0.0, w - 1.0);
    const double y = std::clamp(row.at + 0.5 * (d - 1), 0.0, d - 1.0);
    Spot s{};
    s.mirrored_x = column.mirrored, s.mirrored_y = row.mirrored;
    s.i = std::min(static_cast<int>(x), w - 2);
    s.j = std::min(static_cast<int>(y), d - 2);
    s.u = x - s.i, s.v = y - s.j;
    const double nw = h(s.i, s.j), ne = h(s.i + 1, s.j), sw = h(s.i, s.j + 1),
                 se = h(s.i + 1, s.j + 1);
    const bool north_east = s.u > s.v;
    s.east = north_east ? ne - nw : se - sw;
    s.south = north_east ? se - ne : sw - nw;
    s.height = nw + s.u * s.east + s.v * s.south;
    return s;
}

Vec3 Mesh::face_normal(const Spot& s) const {
    return normalized({-s.mirrored_x * s.east, s.mirrored_y * s.south, terrain_.spacing});
}

Vec3 Mesh::smooth_normal(const Spot& s) const {
    const Field<float>& h = terrain_.heights;
    const auto at = [&](int x, int y) {
        const int x0 = std::max(x - 1, 0), x1 = std::min(x + 1, h.width() - 1);
        const int y0 = std::max(y - 1, 0), y1 = std::min(y + 1, h.height() - 1);
        return normalized({-(h(x1, y) - h(x0, y)) / float(x1 - x0),
                           (h(x, y1) - h(x, y0)) / float(y1 - y0), terrain_.spacing});
    };
    const Vec3 nw = at(s.i, s.j), se = at(s.i + 1, s.j + 1);
    const bool north_east = s.u > s.v;
    const Vec3 third = north_east ? at(s.i + 1, s.j) : at(s.i, s.j + 1);
    const double most = std::max(s.u, s.v), least = std::min(s.u, s.v);
    const Vec3 n = normalized((1.0 - most) * nw + (most - least) * third + least * se);
    return {s.mirrored_x * n.x, s.mirrored_y * n.y, n.z};
}

Vec3 Mesh::side_normal(const Vec3& p) const {
    const int w = terrain_.heights.width(), d = terrain_.heights.height();
    const Folded x = folded(p.x / terrain_.spacing - 0.5 * w, w);
    const Folded y = folded(p.y / terrain_.spacing - 0.5 * d, d);
    if (std::abs(x.at) / (w - 1) > std::abs(y.at) / (d - 1))
        return {x.mirrored * (x.at < 0.0 ? -1.0 : 1.0), 0.0, 0.0};
    return {0.0, y.mirrored * (y.at < 0.0 ? -1.0 : 1.0), 0.0};
}

std::array<double, 2> Mesh::on_land(double east, double north) const {
    const int w = terrain_.heights.width(), d = terrain_.heights.height();
    const double s = terrain_.spacing;
    return {s * (folded(east / s - 0.5 * w, w).at + 0.5 * w),
            s * (folded(north / s - 0.5 * d, d).at + 0.5 * d)};
}

}  // namespace cydonia::render
