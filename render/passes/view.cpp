#include "render/passes/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "field/error.h"
#include "field/parallel.h"
#include "field/quantise.h"
#include "render/camera_view.h"
#include "render/embree/embree.h"
#include "render/pov/water.h"

namespace cydonia::render {
namespace {

using embree::Vertex;
using embree::vertex;

constexpr int kMaxSide = 16384;
constexpr int kTile = 4;  // 4x4 neighbouring pixels are one packet of rays
constexpr int kRays = kTile * kTile;
constexpr double kNever = std::numeric_limits<double>::infinity();

std::array<float, 3> floats(const Vec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// What a ray met, and how far away, metres.
struct Meeting {
    double distance = kNever;
    Surface surface = Surface::kSky;
    void take(double other, Surface what) {
        if (other < distance) distance = other, surface = what;
    }
};

// A level plane, inside the mesh's border, outside it or everywhere.
struct Plane {
    double height;
    bool inside, outside;
    Surface surface;
};

}  // namespace

// Embree's x, y and z are metres east, north and up from the middle of the land, over the
// spacing.
struct View::Scene {
    Scene(const Terrain& land, const std::optional<WaterOptions>& flood);

    void lay_land();
    void lay_side(int count, const std::function<Vertex(int)>& rim);
    void lay_water(const Field<float>& surface);
    Vertex corner(const Field<float>& heights, int x, int y) const {
        return vertex({x - 0.5 * (width - 1), 0.5 * (height - 1) - y,
                       (heights(x, y) - middle) / terrain.spacing});
    }
    Vec3 to_embree(const Vec3& p) const {
        const double s = terrain.spacing;
        return {p.x / s - 0.5 * width, p.y / s - 0.5 * height, (p.z - middle) / s};
    }
    bool over_mesh(const Vec3& p) const {
        const double s = terrain.spacing;
        return p.x >= 0.5 * s && p.y >= 0.5 * s && p.x <= (width - 0.5) * s &&
               p.y <= (height - 0.5) * s;
    }

    // Where a place is on the mesh: its square, how far in it, its triangle's slopes
    // (rise a cell, east and south), and the height.
    struct Spot {
        int i, j;
        double u, v;
        double east, south;
        double height;
    };
    Spot spot(double east, double north) const;
    Vec3 smooth_normal(const Spot& spot) const;
    void meet_mesh(const embree::Scene& mesh, const std::array<Ray, kRays>& rays,
                   Surface surface, std::array<Meeting, kRays>& met) const;
    void meet_planes(const Ray& ray, Meeting& met) const;
    SeenPoint point(const Ray& ray, const Meeting& met, bool smooth,
                    const Vec3& forward) const;

    Terrain terrain;
    int width, height;
    double low, middle;
    embree::Device device;
    embree::Scene land;
    std::optional<embree::Scene> water;
    std::vector<Plane> planes;
    float lift = 0.0f;
};

View::Scene::Scene(const Terrain& given, const std::optional<WaterOptions>& flood)
    : width(given.heights.width()),
      height(given.heights.height()),
      device(rtcNewDevice(nullptr)),
      land(embree::new_scene(device)) {
    terrain.heights = heights_of(quantised(given.heights));
    terrain.spacing = given.spacing;
    const auto [lowest, highest] = std::ranges::minmax(terrain.heights);
    low = lowest;
    middle = 0.5 * (static_cast<double>(lowest) + highest);
    const double reach =
        std::max({0.5 * width, 0.5 * height,
                  (static_cast<double>(highest) - middle) / terrain.spacing});
    lift = static_cast<float>(4.0 * reach * std::numeric_limits<float>::epsilon());
    lay_land();

    const double around = outskirts_height(terrain);
    planes.push_back({around, false, true, Surface::kOutskirts});
    if (flood) {
        const double level = flood->level.in(terrain.width());
        planes.push_back({level, true, level >= around, Surface::kWater});
    }
    if (const auto surface = water_surface(given)) {
        lay_water(heights_of(surface->heights));
        if (surface->sea) planes.push_back({*surface->sea, false, true, Surface::kWater});
    }
    if (rtcGetDeviceError(device.get()) != RTC_ERROR_NONE)
        throw failure("not enough memory to look at {}x{} heights", width, height);
}

void View::Scene::lay_land() {
    const Field<float>& h = terrain.heights;
    embree::lay_grid(device, land, width, height, [&](Vertex* laid) {
        parallel_for(height, 16, [&](int y) {
            Vertex* out = laid + static_cast<std::size_t>(height - 1 - y) * width;
            for (int x = 0; x < width; ++x) out[x] = corner(h, x, y);
        });
    });
    lay_side(width, [&](int x) { return corner(h, x, 0); });
    lay_side(width, [&](int x) { return corner(h, x, height - 1); });
    lay_side(height, [&](int y) { return corner(h, 0, y); });
    lay_side(height, [&](int y) { return corner(h, width - 1, y); });
    rtcCommitScene(land.get());
}

// From the land's rim down to its lowest ground.
void View::Scene::lay_side(int count, const std::function<Vertex(int)>& rim) {
    const auto foot = static_cast<float>((low - middle) / terrain.spacing);
    embree::lay_grid(device, land, count, 2, [&](Vertex* laid) {
        for (int i = 0; i < count; ++i) {
            laid[i] = laid[count + i] = rim(i);
            laid[i].z = foot;
        }
    });
}

void View::Scene::lay_water(const Field<float>& surface) {
    water.emplace(embree::new_scene(device));
    embree::lay_grid(device, *water, width, height, [&](Vertex* laid) {
        parallel_for(height, 16, [&](int y) {
            Vertex* out = laid + static_cast<std::size_t>(height - 1 - y) * width;
            for (int x = 0; x < width; ++x) out[x] = corner(surface, x, y);
        });
    });
    rtcCommitScene(water->get());
}

View::Scene::Spot View::Scene::spot(double east, double north) const {
    const Field<float>& h = terrain.heights;
    const double x = std::clamp(east / terrain.spacing - 0.5, 0.0, width - 1.0);
    const double y =
        std::clamp(height - 0.5 - north / terrain.spacing, 0.0, height - 1.0);
    Spot s{};
    s.i = std::min(static_cast<int>(x), width - 2);
    s.j = std::min(static_cast<int>(y), height - 2);
    s.u = x - s.i, s.v = y - s.j;
    const double nw = h(s.i, s.j), ne = h(s.i + 1, s.j), sw = h(s.i, s.j + 1),
                 se = h(s.i + 1, s.j + 1);
    const bool north_east = s.u > s.v;
    s.east = north_east ? ne - nw : se - sw;
    s.south = north_east ? se - ne : sw - nw;
    s.height = nw + s.u * s.east + s.v * s.south;
    return s;
}

Vec3 View::Scene::smooth_normal(const Spot& s) const {
    const Field<float>& h = terrain.heights;
    const auto at = [&](int x, int y) {
        const int x0 = std::max(x - 1, 0), x1 = std::min(x + 1, width - 1);
        const int y0 = std::max(y - 1, 0), y1 = std::min(y + 1, height - 1);
        return normalized({-(h(x1, y) - h(x0, y)) / float(x1 - x0),
                           (h(x, y1) - h(x, y0)) / float(y1 - y0), terrain.spacing});
    };
    const Vec3 nw = at(s.i, s.j), se = at(s.i + 1, s.j + 1);
    const bool north_east = s.u > s.v;
    const Vec3 third = north_east ? at(s.i + 1, s.j) : at(s.i, s.j + 1);
    const double most = std::max(s.u, s.v), least = std::min(s.u, s.v);
    return normalized((1.0 - most) * nw + (most - least) * third + least * se);
}

void View::Scene::meet_mesh(const embree::Scene& mesh, const std::array<Ray, kRays>& rays,
                            Surface surface, std::array<Meeting, kRays>& met) const {
    alignas(64) RTCRayHit16 packet{};
    alignas(64) std::array<int, kRays> valid{};
    for (std::size_t i = 0; i < kRays; ++i) {
        const Vertex from = vertex(to_embree(rays[i].from));
        const Vertex way = vertex(rays[i].direction);
        packet.ray.org_x[i] = from.x, packet.ray.org_y[i] = from.y;
        packet.ray.org_z[i] = from.z;
        packet.ray.dir_x[i] = way.x, packet.ray.dir_y[i] = way.y;
        packet.ray.dir_z[i] = way.z;
        packet.ray.tfar[i] = static_cast<float>(met[i].distance / terrain.spacing);
        packet.ray.mask[i] = ~0u;
        packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        valid[i] = -1;
    }
    embree::find_hits(mesh.get(), valid.data(), packet);
    for (std::size_t i = 0; i < kRays; ++i) {
        const unsigned hit = packet.hit.geomID[i];
        if (hit == RTC_INVALID_GEOMETRY_ID) continue;
        met[i].take(packet.ray.tfar[i] * terrain.spacing,
                    surface == Surface::kLand && hit > 0 ? Surface::kSide : surface);
    }
}

void View::Scene::meet_planes(const Ray& ray, Meeting& met) const {
    for (const Plane& plane : planes) {
        const double distance = (plane.height - ray.from.z) / ray.direction.z;
        if (!(distance > 0.0) || !(distance < met.distance)) continue;
        const bool over = over_mesh(ray.from + distance * ray.direction);
        if (over ? plane.inside : plane.outside) met.take(distance, plane.surface);
    }
}

SeenPoint View::Scene::point(const Ray& ray, const Meeting& met, bool smooth,
                             const Vec3& forward) const {
    if (met.surface == Surface::kSky) return {};
    Vec3 at = ray.from + met.distance * ray.direction;
    Vec3 normal{0.0, 0.0, 1.0};
    if (met.surface == Surface::kLand) {
        const Spot s = spot(at.x, at.y);
        normal =
            smooth ? smooth_normal(s) : normalized({-s.east, s.south, terrain.spacing});
        // What is left of single precision would hide the point from itself; never where
        // the mesh is nearly upright.
        if (std::abs(s.height - at.z) < 0.01 * terrain.spacing) at.z = s.height;
    } else if (met.surface == Surface::kSide) {
        const Vec3 p = to_embree(at);
        normal = std::abs(p.x) / (width - 1) > std::abs(p.y) / (height - 1)
                     ? Vec3{p.x < 0.0 ? -1.0 : 1.0, 0.0, 0.0}
                     : Vec3{0.0, p.y < 0.0 ? -1.0 : 1.0, 0.0};
    }
    return {floats(at), floats(normal), static_cast<float>(dot(at - ray.from, forward)),
            met.surface};
}

View::View(const Terrain& terrain, const std::optional<WaterOptions>& flood) {
    const Field<float>& h = terrain.heights;
    if (std::min(h.width(), h.height()) < 2 || std::max(h.width(), h.height()) > kMaxSide)
        throw bad_request("passes need 2x2 to {0}x{0} heights, not {1}x{2}", kMaxSide,
                          h.width(), h.height());
    if (!(terrain.spacing > 0.0) ||
        !std::ranges::all_of(h, [](float v) { return std::isfinite(v); }))
        throw bad_request("passes need finite heights and a cell size above 0 m");
    scene_ = std::make_unique<Scene>(terrain, flood);
}
View::~View() = default;

const Terrain& View::terrain() const { return scene_->terrain; }

Field<SeenPoint> View::seen(const CameraRays& rays, bool smooth) const {
    const Scene& scene = *scene_;
    Field<SeenPoint> points(rays.width(), rays.height());
    parallel_for((points.height() + kTile - 1) / kTile, [&](int band) {
        const int y0 = band * kTile;
        for (int x0 = 0; x0 < points.width(); x0 += kTile) {
            std::array<Ray, kRays> packet;
            std::array<Meeting, kRays> met{};
            for (int i = 0; i < kRays; ++i)
                packet[i] = rays.through(x0 + i % kTile + 0.5, y0 + i / kTile + 0.5);
            scene.meet_mesh(scene.land, packet, Surface::kLand, met);
            if (scene.water) scene.meet_mesh(*scene.water, packet, Surface::kWater, met);
            for (int i = 0; i < kRays; ++i) {
                const int x = x0 + i % kTile, y = y0 + i / kTile;
                if (!points.contains(x, y)) continue;
                scene.meet_planes(packet[i], met[i]);
                points(x, y) = scene.point(packet[i], met[i], smooth, rays.forward());
            }
        }
    });
    return points;
}

Field<std::uint8_t> View::shadow(const Field<SeenPoint>& points, const Sun& sun) const {
    const Scene& scene = *scene_;
    const Vec3 to_sun = direction_to(sun);
    const Vertex way = vertex(to_sun);
    Field<std::uint8_t> shadow(points.width(), points.height());
    parallel_for((points.height() + kTile - 1) / kTile, [&](int band) {
        const int y0 = band * kTile;
        for (int x0 = 0; x0 < points.width(); x0 += kTile) {
            alignas(64) RTCRay16 packet{};
            alignas(64) std::array<int, kRays> faces_sun{};
            for (int i = 0; i < kRays; ++i) {
                const int x = x0 + i % kTile, y = y0 + i / kTile;
                if (!points.contains(x, y)) continue;
                const SeenPoint& p = points(x, y);
                if (p.surface == Surface::kSky) continue;
                Vec3 at{p.at[0], p.at[1], p.at[2]};
                Vec3 normal{p.normal[0], p.normal[1], p.normal[2]};
                if (p.surface == Surface::kLand) {
                    const Scene::Spot s = scene.spot(at.x, at.y);
                    normal = {-s.east, s.south, scene.terrain.spacing};
                    at.z = s.height;
                }
                faces_sun[i] = dot(normal, to_sun) > 0.0 ? -1 : 0;
                const Vertex from = vertex(scene.to_embree(at));
                packet.org_x[i] = from.x, packet.org_y[i] = from.y;
                packet.org_z[i] = from.z;
                // A side would shade itself.
                if (p.surface == Surface::kSide)
                    packet.tnear[i] = 1e-3f;
                else
                    packet.org_z[i] += scene.lift;
            }
            std::fill_n(packet.dir_x, kRays, way.x);
            std::fill_n(packet.dir_y, kRays, way.y);
            std::fill_n(packet.dir_z, kRays, way.z);
            std::fill_n(packet.tfar, kRays, std::numeric_limits<float>::infinity());
            std::fill_n(packet.mask, kRays, ~0u);
            embree::mark_occluded(scene.land.get(), faces_sun.data(), packet);
            for (int i = 0; i < kRays; ++i) {
                const int x = x0 + i % kTile, y = y0 + i / kTile;
                if (points.contains(x, y) && points(x, y).surface != Surface::kSky)
                    shadow(x, y) = !faces_sun[i] || packet.tfar[i] < 0.0f;
            }
        }
    });
    return shadow;
}

}  // namespace cydonia::render
