// Khronos, glTF 2.0 specification and its extension KHR_lights_punctual. Assimp's
// exporter drops cameras and lights (5.2), and it bakes nothing.
#include "render/gltf/scene.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "field/parallel.h"
#include "field/rgb.h"
#include "render/gltf/glb.h"
#include "render/gltf/surface.h"
#include "render/ground/ground.h"
#include "render/scene/water.h"
#include "render/sky/sky.h"

namespace cydonia::render {
namespace {

using Json = Glb::Json;

constexpr int kLongestTexture = 2048;  // pixels a side
constexpr int kMostDetail = 4;         // pixels a sample
constexpr int kQuality = 92;           // of the colours' JPEG
// Illuminance of the sun and of the full moon outside the air, on a surface facing them.
constexpr double kSunLux = 128'000.0, kMoonLux = 0.32;

// The colours of the ground in sRGB, averaged down to kLongestTexture.
Field<Rgb8> colours_of(const Terrain& terrain, const GroundOptions& ground) {
    const int longest = std::max(terrain.heights.width(), terrain.heights.height());
    const Field<Rgb> albedo = ground_albedo(
        terrain, ground, std::clamp(kLongestTexture / longest, 1, kMostDetail));
    Field<Rgb8> result;
    for (std::size_t c = 0; c < 3; ++c) {
        Field<float> channel(albedo.width(), albedo.height());
        std::ranges::transform(albedo, channel.begin(),
                               [c](const Rgb& colour) { return colour[c]; });
        channel = at_most(channel, kLongestTexture);
        if (result.empty()) result = {channel.width(), channel.height()};
        parallel_for(channel.height(), 8, [&](int y) {
            for (int x = 0; x < channel.width(); ++x)
                result(x, y)[c] = srgb_level(channel(x, y));
        });
    }
    return result;
}

int mesh_of(Glb& glb, const char* name, const SurfaceMesh& s, int material,
            bool textured) {
    Json attributes = {{"POSITION", glb.attribute(s.positions, 3)},
                       {"NORMAL", glb.attribute(s.normals, 3)}};
    if (textured) {
        attributes["TANGENT"] = glb.attribute(s.tangents, 4);
        attributes["TEXCOORD_0"] = glb.attribute(s.places, 2);
    }
    return glb.add("meshes", {{"name", name},
                              {"primitives",
                               {{{"attributes", attributes},
                                 {"indices", glb.indices(s.indices)},
                                 {"material", material}}}}});
}

Json matt(Json rest) {
    rest["metallicFactor"] = 0.0;
    rest["roughnessFactor"] = 1.0;
    return rest;
}

void add_land(Glb& glb, const Terrain& terrain, const GroundOptions& ground,
              const Field<float>& coarse, GltfScene& made) {
    const Field<Rgb8> colours = colours_of(terrain, ground);
    const Field<Rgb8> normals = normal_map(at_most(terrain.heights, kLongestTexture),
                                           coarse, terrain.width(), terrain.depth());
    const int colour = glb.texture(glb.image(jpeg_of(colours, kQuality), "image/jpeg"));
    const int normal = glb.texture(glb.image(png_of(normals), "image/png"));
    const int material = glb.add(
        "materials",
        {{"name", "ground"},
         {"pbrMetallicRoughness", matt({{"baseColorTexture", {{"index", colour}}}})},
         {"normalTexture", {{"index", normal}}}});
    const SurfaceMesh surface = surface_mesh(coarse, terrain.width(), terrain.depth());
    const int mesh = mesh_of(glb, "land", surface, material, true);
    glb.add("nodes", {{"name", "land"}, {"mesh", mesh}});
    made.samples = {coarse.width(), coarse.height()};
    made.colour = {colours.width(), colours.height()};
    made.normals = {normals.width(), normals.height()};
    made.triangles = surface.indices.size() / 3;
}

// The mesh's own heights with the water of the nearest samples, so that both meet at the
// shore.
Terrain coarse_land(const Terrain& terrain, const Field<float>& coarse) {
    Terrain result{coarse, terrain.width() / coarse.width(), {}, {}, {}};
    if (terrain.water.empty()) return result;
    result.water = Field<float>(coarse.width(), coarse.height());
    for (int y = 0; y < coarse.height(); ++y)
        for (int x = 0; x < coarse.width(); ++x)
            result.water(x, y) = terrain.water(
                (2 * x + 1) * terrain.heights.width() / (2 * coarse.width()),
                (2 * y + 1) * terrain.heights.height() / (2 * coarse.height()));
    return result;
}

void add_water(Glb& glb, const Terrain& terrain, const Terrain& coarse) {
    const SurfaceMesh surface = water_mesh(coarse, terrain.width(), terrain.depth());
    if (surface.indices.empty()) return;
    const int material = glb.add("materials", {{"name", "water"},
                                               {"alphaMode", "BLEND"},
                                               {"pbrMetallicRoughness",
                                                {{"baseColorFactor", kPlainWater},
                                                 {"metallicFactor", 0.0},
                                                 {"roughnessFactor", 0.1}}}});
    glb.add("nodes", {{"name", "water"},
                      {"mesh", mesh_of(glb, "water", surface, material, false)}});
}

// The rotation of a light or a camera, which look along their own -z.
Json turned(const Vec3& right, const Vec3& up, const Vec3& back) {
    return rotation_to(in_gltf(right), in_gltf(up), in_gltf(back));
}

double add_sun(Glb& glb, const Shot& shot) {
    const Rgb light = daylight(shot.sun, shot.options.sky).sun;
    const float most = std::max({light[0], light[1], light[2], 1e-6f});
    const Rgb colour{light[0] / most, light[1] / most, light[2] / most};
    const double luminance = 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];
    const double lux = luminance * (shot.options.sky.moon > 0.0 ? kMoonLux : kSunLux);
    // Viewers multiply colour and intensity.
    const double share = 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2];

    glb.json["extensionsUsed"] = Json::array({"KHR_lights_punctual"});
    glb.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"name", "sun"},
         {"type", "directional"},
         {"color", colour},
         {"intensity", lux / share}}};
    const Vec3 back = direction_to(shot.sun);
    const Vec3 right = normalized(cross(Vec3{0.0, 0.0, 1.0}, back));
    glb.add("nodes", {{"name", "sun"},
                      {"rotation", turned(right, cross(back, right), back)},
                      {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    return lux;
}

// The distances from the eye to the nearest and the farthest sample, metres.
std::array<double, 2> reach_of(const Vec3& eye, const Terrain& coarse) {
    std::array<double, 2> reach{std::numeric_limits<double>::max(), 0.0};
    const Field<float>& h = coarse.heights;
    for (int y = 0; y < h.height(); ++y)
        for (int x = 0; x < h.width(); ++x) {
            const Vec3 point{coarse.spacing * (x + 0.5),
                             coarse.depth() - coarse.spacing * (y + 0.5), h(x, y)};
            const double distance = length(point - eye);
            reach = {std::min(reach[0], distance), std::max(reach[1], distance)};
        }
    return reach;
}

Json camera_of(const Camera& camera, const Terrain& coarse) {
    const auto [nearest, farthest] = reach_of(camera.eye, coarse);
    const double near = std::max(0.05, 0.25 * nearest), far = 2.0 * farthest + 1.0;
    const double aspect = double(camera.width) / camera.height;
    if (camera.projection == Camera::Projection::kOrthographic)
        return {{"type", "orthographic"},
                {"orthographic",
                 {{"xmag", 0.5 * camera.frame_width},
                  {"ymag", 0.5 * camera.frame_width / aspect},
                  {"znear", near},
                  {"zfar", far}}}};
    const double high = 2.0 * std::atan(std::tan(0.5 * camera.field_of_view) / aspect);
    return {{"type", "perspective"},
            {"perspective",
             {{"aspectRatio", aspect}, {"yfov", high}, {"znear", near}, {"zfar", far}}}};
}

void add_camera(Glb& glb, const Shot& shot, const Terrain& coarse) {
    Json camera = camera_of(shot.camera, coarse);
    camera["name"] = shot.name;
    const CameraAxes axes(shot.camera);
    const Vec3 eye = in_gltf(axes.eye);
    glb.add("nodes", {{"name", shot.name},
                      {"camera", glb.add("cameras", std::move(camera))},
                      {"translation", {eye.x, eye.y, eye.z}},
                      {"rotation", turned(axes.right, axes.up, -1.0 * axes.forward)}});
}

}  // namespace

GltfScene gltf_scene(const Terrain& terrain, const std::vector<Shot>& shots,
                     int samples) {
    assert(!shots.empty() && samples >= 2 && samples <= kMostGltfSamples);
    const Shot& first = shots.front();
    const Terrain coarse = coarse_land(terrain, at_most(terrain.heights, samples));
    GltfScene made;
    Glb glb;
    add_land(glb, terrain, first.options.ground, coarse.heights, made);
    add_water(glb, terrain, coarse);
    made.lux = add_sun(glb, first);
    for (const Shot& shot : shots) add_camera(glb, shot, coarse);

    Json all = Json::array();
    for (std::size_t i = 0; i < glb.json["nodes"].size(); ++i) all.push_back(i);
    glb.json["scene"] = 0;
    glb.json["scenes"] = {{{"name", first.title}, {"nodes", all}}};
    made.file = glb.file();
    return made;
}

}  // namespace cydonia::render
