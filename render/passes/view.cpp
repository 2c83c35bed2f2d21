#include "render/passes/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "field/error.h"
#include "field/parallel.h"
#include "render/cameras/view.h"
#include "render/embree/embree.h"
#include "render/passes/copies.h"
#include "render/passes/mesh.h"
#include "render/scene/things.h"
#include "render/scene/water.h"
#include "render/shadow/soft.h"
#include "render/sky/clouds.h"

namespace cydonia::render {
namespace {

using embree::Vertex;
using embree::vertex;

constexpr int kLandsAround = 2;  // copies of the land on each side, as in the .pov
constexpr int kDiscPairs = 16;   // pairs of directions to the sun that sample a penumbra
constexpr int kTile = 4;         // 4x4 neighbouring pixels are one packet of rays
constexpr int kRays = kTile * kTile;
constexpr double kNever = std::numeric_limits<double>::infinity();

std::array<float, 3> floats(const Vec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

}  // namespace

// Embree's x, y and z are metres east, north and up from the middle of the land, divided
// by the spacing.
struct View::Scene {
    // The first hit of a ray and its distance, metres.
    struct Hit {
        double distance = kNever;
        Surface surface = Surface::kSky;
        unsigned instance = 0, geometry = 0, triangle = 0;  // of a thing, and where on it
        float u = 0.0f, v = 0.0f;
    };

    // A level plane. `lands` copies on each side of the land bound its inside; it exists
    // inside, outside or both.
    struct Plane {
        double height;
        int lands;
        bool inside, outside;
        Surface surface;
    };

    // Where the rays from a seen point to the sun begin, in Embree's space, and the
    // surface's normal there.
    struct ShadowRayOrigin {
        Vertex from{};
        Vec3 normal{};  // zero for the sky
    };

    Scene(const Terrain& land, const Scenery& scenery);

    void lay_land();
    void lay_side(int count, const std::function<Vertex(int)>& rim);
    void lay_water(const Field<float>& surface);
    void lay_around(embree::Scene& around, const embree::Scene& what);
    Vertex corner(const Field<float>& heights, int x, int y) const {
        return vertex({x - 0.5 * (width - 1), 0.5 * (height - 1) - y,
                       (heights(x, y) - space.middle.z) / space.unit});
    }
    Vec3 to_embree(const Vec3& p) const {
        return (1.0 / space.unit) * (p - space.middle);
    }

    using Rays = std::array<Ray, kRays>;
    using Hits = std::array<Hit, kRays>;
    void intersect(RTCScene scene, const Rays& rays, Surface surface, Hits& hits) const;
    void intersect_planes(const Ray& ray, Hit& hit) const;
    SeenPoint point(const Ray& ray, const Hit& hit, bool smooth,
                    const Vec3& forward) const;

    using ShadowRayOrigins = std::array<ShadowRayOrigin, kRays>;
    using Which = std::array<int, kRays>;  // -1 or 0, as Embree expects
    ShadowRayOrigin shadow_ray_origin(const SeenPoint& point) const;
    // Of the asked origins those from which the sun is occluded.
    Which occluded(const ShadowRayOrigins& from, const Vec3& to_sun,
                   const Which& asked) const;
    void cloud(const Field<SeenPoint>& points, const Sun& sun,
               Field<float>& shadow) const;

    Mesh mesh;
    int width, height;
    EmbreeSpace space;
    float foot = 0.0f;  // of the sides
    embree::Device device;
    embree::Scene land;
    std::optional<embree::Scene> around, water, water_around;
    std::optional<Copies> things;
    bool has_things;  // whether the scene has things, in view or not
    SkyOptions sky;
    bool holds_image;
    std::vector<Plane> planes;
    float lift = 0.0f;
};

View::Scene::Scene(const Terrain& given, const Scenery& scenery)
    : mesh(given),
      width(given.heights.width()),
      height(given.heights.height()),
      device(rtcNewDevice(nullptr)),
      land(embree::new_scene(device)),
      has_things(!scenery.kinds.empty()),
      sky(scenery.sky),
      holds_image(scenery.holds_image) {
    const Terrain& terrain = mesh.terrain();
    const auto [low, high] = std::ranges::minmax(terrain.heights);
    space = {{0.5 * terrain.width(), 0.5 * terrain.depth(), 0.5 * (double(low) + high)},
             terrain.spacing};
    foot = static_cast<float>((low - space.middle.z) / space.unit);
    const double reach = std::max({0.5 * width, 0.5 * height, -double(foot)});
    lift = static_cast<float>(4.0 * reach * std::numeric_limits<float>::epsilon());
    const bool goes_on = scenery.around == Around::kLand;
    lay_land();
    if (goes_on) lay_around(around.emplace(embree::new_scene(device)), land);

    const double level = outskirts_height(terrain);
    const int lands = goes_on ? kLandsAround : 0;
    planes.push_back({level, lands, false, true, Surface::kOutskirts});
    if (scenery.flood) {
        const double flood = scenery.flood->level.in(terrain.width());
        planes.push_back({flood, lands, true, flood >= level, Surface::kWater});
    }
    if (const auto surface = water_surface(given)) {
        lay_water(heights_of(surface->heights));
        if (goes_on) lay_around(water_around.emplace(embree::new_scene(device)), *water);
        if (surface->sea)
            planes.push_back({*surface->sea, 0, false, true, Surface::kWater});
    }
    things.emplace(device.get(), scenery.kinds, scenery.things, space);
    if (things->empty()) things.reset();
    if (rtcGetDeviceError(device.get()) != RTC_ERROR_NONE)
        throw failure("not enough memory to look at {}x{} heights", width, height);
}

void View::Scene::lay_land() {
    const Field<float>& h = mesh.terrain().heights;
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

// A side wall from the land's rim down to its lowest height.
void View::Scene::lay_side(int count, const std::function<Vertex(int)>& rim) {
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

// Adds copies of `what`, mirrored at the land's borders.
void View::Scene::lay_around(embree::Scene& copies, const embree::Scene& what) {
    for (int i = -kLandsAround; i <= kLandsAround; ++i)
        for (int j = -kLandsAround; j <= kLandsAround; ++j) {
            if (i == 0 && j == 0) continue;
            embree::lay_instance(device.get(), copies.get(), what.get(),
                                 {i % 2 ? -1.0f : 1.0f, 0, 0,  //
                                  0, j % 2 ? -1.0f : 1.0f, 0,  //
                                  0, 0, 1,                     //
                                  float(i * (width - 1)), float(j * (height - 1)), 0});
        }
    rtcCommitScene(copies.get());
}

void View::Scene::intersect(RTCScene scene, const Rays& rays, Surface surface,
                            Hits& hits) const {
    alignas(64) RTCRayHit16 packet{};
    alignas(64) Which valid{};
    for (std::size_t i = 0; i < kRays; ++i) {
        const Vertex from = vertex(to_embree(rays[i].from));
        const Vertex way = vertex(rays[i].direction);
        packet.ray.org_x[i] = from.x, packet.ray.org_y[i] = from.y;
        packet.ray.org_z[i] = from.z;
        packet.ray.dir_x[i] = way.x, packet.ray.dir_y[i] = way.y;
        packet.ray.dir_z[i] = way.z;
        packet.ray.tfar[i] = static_cast<float>(hits[i].distance / space.unit);
        packet.ray.mask[i] = ~0u;
        packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        valid[i] = -1;
    }
    const bool copies = scene != land.get() && (!water || scene != water->get());
    embree::find_hits(scene, valid.data(), packet,
                      copies ? embree::Follow::kAlone : embree::Follow::kTogether);
    const auto& found = packet.hit;
    for (std::size_t i = 0; i < kRays; ++i) {
        const double distance = packet.ray.tfar[i] * space.unit;
        if (found.geomID[i] == RTC_INVALID_GEOMETRY_ID || distance >= hits[i].distance)
            continue;
        const bool side = surface == Surface::kLand && found.geomID[i] > 0;
        hits[i] = {distance,           side ? Surface::kSide : surface,
                   found.instID[0][i], found.geomID[i],
                   found.primID[i],    found.u[i],
                   found.v[i]};
    }
}

void View::Scene::intersect_planes(const Ray& ray, Hit& hit) const {
    for (const Plane& plane : planes) {
        const double distance = (plane.height - ray.from.z) / ray.direction.z;
        if (!(distance > 0.0) || !(distance < hit.distance)) continue;
        const bool over = mesh.is_under(ray.from + distance * ray.direction, plane.lands);
        if (over ? plane.inside : plane.outside)
            hit = {distance, plane.surface, 0, 0, 0, 0.0f, 0.0f};
    }
}

SeenPoint View::Scene::point(const Ray& ray, const Hit& hit, bool smooth,
                             const Vec3& forward) const {
    if (hit.surface == Surface::kSky) return {};
    SeenPoint seen;
    seen.surface = hit.surface;
    Vec3 at = ray.from + hit.distance * ray.direction;
    Vec3 normal{0.0, 0.0, 1.0};
    if (hit.surface == Surface::kLand) {
        const Mesh::Spot s = mesh.spot(at.x, at.y);
        normal = smooth ? mesh.smooth_normal(s) : mesh.face_normal(s);
        // Puts the point exactly on the mesh, since rounding could shadow it by itself.
        // Where the mesh is nearly upright the two heights differ and the hit stays.
        if (std::abs(s.height - at.z) < 0.01 * space.unit) at.z = s.height;
    } else if (hit.surface == Surface::kSide) {
        normal = mesh.side_normal(at);
        if (dot(normal, ray.direction) > 0.0) normal = -1.0 * normal;  // on the very rim
    } else if (hit.surface == Surface::kThing) {
        const Copies::Facet facet =
            things->facet(hit.instance, hit.geometry, hit.triangle, hit.u, hit.v);
        normal =
            dot(facet.normal, ray.direction) > 0.0 ? -1.0 * facet.normal : facet.normal;
        seen.thing = static_cast<std::uint8_t>(facet.kind + 1);
        seen.shape = facet.shape;
    }
    seen.at = floats(at);
    seen.normal = floats(normal);
    seen.depth = static_cast<float>(dot(at - ray.from, forward));
    return seen;
}

View::Scene::ShadowRayOrigin View::Scene::shadow_ray_origin(const SeenPoint& p) const {
    if (p.surface == Surface::kSky) return {};
    Vec3 at = vec3_of(p.at), normal = vec3_of(p.normal);
    if (p.surface == Surface::kLand) {
        const Mesh::Spot s = mesh.spot(at.x, at.y);
        normal = mesh.face_normal(s);
        at.z = s.height;
    }
    Vertex from = vertex(to_embree(at));
    // The origin is moved off a leaf or a side wall, which would shadow itself.
    if (p.surface == Surface::kThing || p.surface == Surface::kSide) {
        const float off = 8.0f * lift;
        return {{from.x + off * p.normal[0], from.y + off * p.normal[1],
                 from.z + off * p.normal[2]},
                normal};
    }
    from.z += lift;
    return {from, normal};
}

View::Scene::Which View::Scene::occluded(const ShadowRayOrigins& from, const Vec3& to_sun,
                                         const Which& asked) const {
    const Vertex way = vertex(to_sun);
    alignas(64) RTCRay16 packet{};
    alignas(64) Which valid{};
    Which result{};
    for (std::size_t i = 0; i < kRays; ++i) {
        if (!asked[i]) continue;
        valid[i] = dot(from[i].normal, to_sun) > 0.0 ? -1 : 0;
        result[i] = valid[i] ? 0 : -1;
        packet.org_x[i] = from[i].from.x, packet.org_y[i] = from[i].from.y;
        packet.org_z[i] = from[i].from.z;
        packet.tnear[i] = 0.0f;
    }
    std::fill_n(packet.dir_x, kRays, way.x);
    std::fill_n(packet.dir_y, kRays, way.y);
    std::fill_n(packet.dir_z, kRays, way.z);
    std::fill_n(packet.tfar, kRays, std::numeric_limits<float>::infinity());
    std::fill_n(packet.mask, kRays, ~0u);
    const auto mark = [&](RTCScene scene, embree::Follow follow) {
        if (std::ranges::none_of(valid, [](int v) { return v != 0; })) return;
        embree::mark_occluded(scene, valid.data(), packet, follow);
        for (std::size_t i = 0; i < kRays; ++i)
            if (valid[i] && packet.tfar[i] < 0.0f) result[i] = -1, valid[i] = 0;
    };
    mark(land.get(), embree::Follow::kTogether);
    if (things) mark(things->scene(), embree::Follow::kAlone);
    return result;
}

void View::Scene::cloud(const Field<SeenPoint>& points, const Sun& sun,
                        Field<float>& shadow) const {
    if (!throw_shadows(sky, sun, holds_image)) return;
    const CloudLayer clouds(sky.clouds, sun);
    const Vec3 middle{space.middle.x, space.middle.y,
                      space.middle.z + space.unit * double(foot)};
    parallel_for(points.height(), 4, [&](int y) {
        for (int x = 0; x < points.width(); ++x) {
            if (points(x, y).surface == Surface::kSky || shadow(x, y) >= 1.0f) continue;
            const double through =
                clouds.sunlight_through(vec3_of(points(x, y).at) - middle);
            shadow(x, y) = static_cast<float>(1.0 - (1.0 - shadow(x, y)) * through);
        }
    });
}

Scenery scenery_of(const Shot& shot, const Terrain& terrain) {
    return {shot.options.water,       shot.around,      shot.options.things,
            things_of(shot, terrain), shot.options.sky, !terrain.shadows.empty()};
}

View::View(const Terrain& terrain, const Scenery& scenery) {
    const Field<float>& h = terrain.heights;
    if (std::min(h.width(), h.height()) < 2 ||
        std::max(h.width(), h.height()) > kLargestSide)
        throw bad_request("passes need 2x2 to {0}x{0} heights, not {1}x{2}", kLargestSide,
                          h.width(), h.height());
    if (!(terrain.spacing > 0.0) ||
        !std::ranges::all_of(h, [](float v) { return std::isfinite(v); }))
        throw bad_request("passes need finite heights and a cell size above 0 m");
    scene_ = std::make_unique<Scene>(terrain, scenery);
}
View::~View() = default;

const Terrain& View::terrain() const { return scene_->mesh.terrain(); }

std::array<double, 2> View::on_land(const SeenPoint& p) const {
    return scene_->mesh.on_land(p.at[0], p.at[1]);
}

bool View::has_things() const { return scene_->has_things; }

Rgb View::albedo(const SeenPoint& thing) const {
    return scene_->things->shapes()[thing.shape].part.albedo;
}

Field<SeenPoint> View::seen(const CameraRays& rays, bool smooth) const {
    const Scene& scene = *scene_;
    Field<SeenPoint> points(rays.width(), rays.height());
    parallel_for((points.height() + kTile - 1) / kTile, [&](int band) {
        const int y0 = band * kTile;
        for (int x0 = 0; x0 < points.width(); x0 += kTile) {
            Scene::Rays packet;
            Scene::Hits hits{};
            for (int i = 0; i < kRays; ++i)
                packet[i] = rays.through(x0 + i % kTile + 0.5, y0 + i / kTile + 0.5);
            scene.intersect(scene.land.get(), packet, Surface::kLand, hits);
            if (scene.around)
                scene.intersect(scene.around->get(), packet, Surface::kLand, hits);
            if (scene.water)
                scene.intersect(scene.water->get(), packet, Surface::kWater, hits);
            if (scene.water_around)
                scene.intersect(scene.water_around->get(), packet, Surface::kWater, hits);
            if (scene.things)
                scene.intersect(scene.things->scene(), packet, Surface::kThing, hits);
            for (int i = 0; i < kRays; ++i) {
                const int x = x0 + i % kTile, y = y0 + i / kTile;
                if (!points.contains(x, y)) continue;
                scene.intersect_planes(packet[i], hits[i]);
                points(x, y) = scene.point(packet[i], hits[i], smooth, rays.forward());
            }
        }
    });
    return points;
}

Field<float> View::shadow(const Field<SeenPoint>& points, const Sun& sun,
                          SunAs as) const {
    const Scene& scene = *scene_;
    const auto directions = [](const std::vector<Sun>& suns) {
        std::vector<Vec3> result;
        for (const Sun& s : suns) result.push_back(direction_to(s));
        return result;
    };
    // The rim is that of the square around the disc: a straight edge that misses the
    // square misses the disc.
    const std::vector<Vec3> rim = directions(
        as == SunAs::kDisc ? sun_rim(sun, std::sqrt(2.0)) : std::vector<Sun>{sun});
    const std::vector<Vec3> disc = directions(sun_disc(sun, kDiscPairs));
    Field<float> shadow(points.width(), points.height());
    parallel_for((points.height() + kTile - 1) / kTile, [&](int band) {
        const int y0 = band * kTile;
        for (int x0 = 0; x0 < points.width(); x0 += kTile) {
            Scene::ShadowRayOrigins from{};
            Scene::Which asked{};
            for (int i = 0; i < kRays; ++i) {
                const int x = x0 + i % kTile, y = y0 + i / kTile;
                if (!points.contains(x, y)) continue;
                from[i] = scene.shadow_ray_origin(points(x, y));
                asked[i] = points(x, y).surface == Surface::kSky ? 0 : -1;
            }
            const auto count = [&](const std::vector<Vec3>& suns) {
                Scene::Which sum{};
                for (const Vec3& to_sun : suns) {
                    const Scene::Which dark = scene.occluded(from, to_sun, asked);
                    for (int i = 0; i < kRays; ++i) sum[i] -= dark[i];
                }
                return sum;
            };
            const auto put = [&](const Scene::Which& dark, std::size_t of) {
                for (int i = 0; i < kRays; ++i) {
                    const int x = x0 + i % kTile, y = y0 + i / kTile;
                    if (asked[i])
                        shadow(x, y) =
                            static_cast<float>(dark[i]) / static_cast<float>(of);
                }
            };
            const Scene::Which dark = count(rim);
            put(dark, rim.size());
            for (int i = 0; i < kRays; ++i)
                if (dark[i] == 0 || dark[i] == int(rim.size())) asked[i] = 0;
            if (std::ranges::any_of(asked, [](int a) { return a != 0; }))
                put(count(disc), disc.size());
        }
    });
    scene.cloud(points, sun, shadow);
    return shadow;
}

}  // namespace cydonia::render
