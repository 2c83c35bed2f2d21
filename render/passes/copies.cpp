#include "render/passes/copies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "render/embree/embree.h"

namespace cydonia::render {
namespace {

// Clockwise from above, as POV-Ray turns about its y axis.
Vec3 turned(const Vec3& v, double turn) {
    const double c = std::cos(turn), s = std::sin(turn);
    return {c * v.x + s * v.y, c * v.y - s * v.x, v.z};
}

void lay_triangles(RTCDevice device, const embree::Scene& scene,
                   const Original::Part& part) {
    const embree::Handle<RTCGeometry, rtcReleaseGeometry> mesh(
        rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
    void* vertices =
        rtcSetNewGeometryBuffer(mesh.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(embree::Vertex), part.vertices.size());
    void* triangles = rtcSetNewGeometryBuffer(
        mesh.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
        sizeof(std::array<std::uint32_t, 3>), part.triangles.size());
    if (!vertices || !triangles) return;
    std::ranges::copy(part.vertices, static_cast<std::array<float, 3>*>(vertices));
    std::ranges::copy(part.triangles,
                      static_cast<std::array<std::uint32_t, 3>*>(triangles));
    rtcCommitGeometry(mesh.get());
    rtcAttachGeometry(scene.get(), mesh.get());
}

}  // namespace

struct Copies::Scenes {
    std::vector<embree::Scene> originals;
    embree::Scene copies;
};

Copies::~Copies() = default;

RTCSceneTy* Copies::scene() const { return scenes_->copies.get(); }

Copies::Copies(RTCDevice device, const std::vector<ThingOptions>& kinds,
               const std::vector<std::vector<Thing>>& things, const EmbreeSpace& space)
    : scenes_(new Scenes{{}, embree::new_scene(device)}) {
    struct Made {
        RTCScene scene;
        std::uint8_t first_shape;
    };
    std::map<std::pair<ThingOptions::Kind, int>, Made> made;
    for (std::size_t kind = 0; kind < things.size(); ++kind)
        for (const Thing& thing : things[kind]) {
            const std::pair which{kinds[kind].kind, int(thing.original)};
            if (!made.contains(which)) {
                const auto first = add_original(device, which.first, which.second);
                made[which] = {scenes_->originals.back().get(), first};
            }
            const Made& original = made[which];
            const double scale = thing.height / space.unit;
            const Vec3 foot = (1.0 / space.unit) * (thing.foot - space.middle);
            const Vec3 axes[] = {scale * turned({1, 0, 0}, thing.turn),
                                 scale * turned({0, 1, 0}, thing.turn),
                                 {0, 0, scale},
                                 foot};
            std::array<float, 12> columns;
            for (std::size_t i = 0; i < 4; ++i) {
                columns[3 * i] = float(axes[i].x);
                columns[3 * i + 1] = float(axes[i].y);
                columns[3 * i + 2] = float(axes[i].z);
            }
            embree::lay_instance(device, scene(), original.scene, columns);
            copies_.push_back({thing.turn, std::uint8_t(kind), original.first_shape});
        }
    rtcCommitScene(scene());
}

std::uint8_t Copies::add_original(RTCDevice device, ThingOptions::Kind kind, int number) {
    const auto first = std::uint8_t(shapes_.size());
    embree::Scene scene = embree::new_scene(device);
    for (Original::Part& part : original_of(kind, number).parts) {
        lay_triangles(device, scene, part);
        auto normals =
            part.smooth ? normals_of(part) : std::vector<std::array<float, 3>>{};
        shapes_.push_back({std::move(part), std::move(normals)});
    }
    rtcCommitScene(scene.get());
    scenes_->originals.push_back(std::move(scene));
    return first;
}

Copies::Facet Copies::facet(unsigned instance, unsigned geometry, unsigned triangle,
                            double u, double v) const {
    const Copy& copy = copies_[instance];
    const auto shape = std::uint8_t(copy.first_shape + geometry);
    const auto& [part, normals] = shapes_[shape];
    const auto [a, b, c] = part.triangles[triangle];
    const Vec3 normal = normals.empty()
                            ? cross(vec3_of(part.vertices[b]) - vec3_of(part.vertices[a]),
                                    vec3_of(part.vertices[c]) - vec3_of(part.vertices[a]))
                            : (1.0 - u - v) * vec3_of(normals[a]) +
                                  u * vec3_of(normals[b]) + v * vec3_of(normals[c]);
    return {copy.kind, shape, turned(normalized(normal), copy.turn)};
}

}  // namespace cydonia::render
