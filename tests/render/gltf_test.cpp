// The scene as glTF 2.0: its structure by the specification (Khronos, glTF 2.0, sections
// 3.6, 3.10 and 4.4), and what Assimp reads of it.
#include <gtest/gtest.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "render/cameras/cameras.h"
#include "render/gltf/glb.h"
#include "render/gltf/scene.h"
#include "render/gltf/surface.h"

namespace cydonia::render {
namespace {

using Json = nlohmann::json;

constexpr double kSpacing = 20.0;

// Hills, the north-western corner far above them; not square.
Terrain corner_land(int width = 48, int height = 32) {
    Terrain land{Field<float>(width, height), kSpacing, {}, {}, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            land.heights(x, y) = float(30.0 * std::sin(0.4 * x) * std::cos(0.3 * y));
    land.heights(0, 0) = 400.0f;
    return land;
}

Shot shot_of(const char* name, CameraOptions::Kind kind, const Terrain& land) {
    CameraOptions options;
    options.name = name;
    options.kind = kind;
    options.size = {192, 108};
    Shot shot;
    shot.title = "A \"title\"";
    shot.name = name;
    shot.sun = {radians(215.0), radians(25.0)};
    shot.camera = place(options, land, Quality::kFinal);
    return shot;
}

std::vector<Shot> shots_of(const Terrain& land) {
    return {shot_of("map", CameraOptions::Kind::kOverhead, land),
            shot_of("view", CameraOptions::Kind::kOblique, land)};
}

std::uint32_t word(const std::string& bytes, std::size_t at) {
    std::uint32_t value;
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
}

// A .glb taken apart.
struct Parts {
    Json json;
    std::string buffer;

    explicit Parts(const std::string& file) {
        const std::uint32_t length = word(file, 12);
        json = Json::parse(file.substr(20, length));
        buffer = file.substr(28 + length);
    }
    const Json& accessor(int i) const { return json.at("accessors").at(std::size_t(i)); }
    std::string_view view(int i) const {
        const Json& v = json.at("bufferViews").at(std::size_t(i));
        return std::string_view(buffer).substr(v.at("byteOffset"), v.at("byteLength"));
    }
    template <class T>
    std::vector<T> values(int i) const {
        const std::string_view bytes = view(accessor(i).at("bufferView"));
        std::vector<T> result(bytes.size() / sizeof(T));
        std::memcpy(result.data(), bytes.data(), bytes.size());
        return result;
    }
    const Json& primitive() const {
        return json.at("meshes").at(0).at("primitives").at(0);
    }
    const Json& node(const std::string& name) const {
        for (const Json& node : json.at("nodes"))
            if (node.at("name") == name) return node;
        throw std::runtime_error("no node " + name);
    }
};

// A node's own axis in the world, by its quaternion.
Vec3 turned(const Json& node, const Vec3& v) {
    const auto q = node.at("rotation").get<std::array<double, 4>>();
    const Vec3 u{q[0], q[1], q[2]};
    return 2.0 * dot(u, v) * u + (q[3] * q[3] - dot(u, u)) * v + 2.0 * q[3] * cross(u, v);
}

Field<Rgb8> picture_of(std::string_view bytes, const char* format) {
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
    const std::string name = std::string("memory.") + format;
    const auto file = OIIO::ImageInput::open(name, nullptr, &memory);
    if (!file) throw std::runtime_error("no picture: " + OIIO::geterror());
    Field<Rgb8> picture(file->spec().width, file->spec().height);
    file->read_image(0, 0, 0, 3, OIIO::TypeUInt8, picture.data());
    return picture;
}

const Field<Rgb8> normals_in(const Parts& glb) {
    return picture_of(glb.view(glb.json.at("images").at(1).at("bufferView")), "png");
}

}  // namespace

TEST(Gltf, ChunksFillTheFile) {
    const Terrain land = corner_land();
    const std::string glb = gltf_scene(land, shots_of(land), 512).file;
    EXPECT_TRUE(glb.starts_with("glTF"));
    EXPECT_EQ(word(glb, 4), 2u);
    EXPECT_EQ(word(glb, 8), glb.size());
    const std::uint32_t json = word(glb, 12);
    EXPECT_EQ(glb.substr(16, 4), "JSON");
    EXPECT_EQ(json % 4, 0u);
    const std::uint32_t binary = word(glb, 20 + json);
    EXPECT_EQ(glb.substr(24 + json, 4), std::string("BIN\0", 4));
    EXPECT_EQ(binary % 4, 0u);
    EXPECT_EQ(28 + json + binary, glb.size());
}

TEST(Gltf, EveryAccessorLiesInItsViewAndEveryViewInTheBuffer) {
    const Terrain land = corner_land();
    const Parts glb(gltf_scene(land, shots_of(land), 512).file);
    EXPECT_EQ(glb.json.at("buffers").at(0).at("byteLength"), glb.buffer.size());
    std::size_t end = 0;
    for (const Json& view : glb.json.at("bufferViews")) {
        const std::size_t begin = view.at("byteOffset");
        EXPECT_EQ(begin % 4, 0u);
        EXPECT_GE(begin, end) << "views overlap";
        end = begin + view.at("byteLength").get<std::size_t>();
        EXPECT_LE(end, glb.buffer.size());
    }
    const std::map<std::string, std::size_t> widths{
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
    for (std::size_t i = 0; i < glb.json.at("accessors").size(); ++i) {
        const Json& a = glb.accessor(int(i));
        EXPECT_EQ(glb.view(a.at("bufferView")).size(),
                  4 * widths.at(a.at("type")) * a.at("count").get<std::size_t>());
        if (a.at("componentType") != 5126) continue;
        const auto values = glb.values<float>(int(i));
        const std::size_t width = widths.at(a.at("type"));
        for (std::size_t c = 0; c < width; ++c) {
            float low = values[c], high = values[c];
            for (std::size_t k = c; k < values.size(); k += width) {
                low = std::min(low, values[k]);
                high = std::max(high, values[k]);
            }
            EXPECT_EQ(a.at("min").at(c).get<float>(), low);
            EXPECT_EQ(a.at("max").at(c).get<float>(), high);
        }
    }
    const Json& attributes = glb.primitive().at("attributes");
    const std::size_t vertices = 48 * 32;
    for (const char* name : {"POSITION", "NORMAL", "TANGENT", "TEXCOORD_0"})
        EXPECT_EQ(glb.accessor(attributes.at(name)).at("count"), vertices) << name;
    for (const std::uint32_t i : glb.values<std::uint32_t>(glb.primitive().at("indices")))
        ASSERT_LT(i, vertices);
    for (const Json& i : glb.json.at("scenes").at(0).at("nodes"))
        EXPECT_LT(i.get<std::size_t>(), glb.json.at("nodes").size());
}

TEST(Gltf, MetresWithYUpAndNorthAtMinusZ) {
    const Terrain land = corner_land();
    const Parts glb(gltf_scene(land, shots_of(land), 512).file);
    const auto at = glb.values<float>(glb.primitive().at("attributes").at("POSITION"));
    std::size_t top = 0;
    for (std::size_t i = 0; i < at.size(); i += 3)
        if (at[i + 1] > at[top + 1]) top = i;
    EXPECT_FLOAT_EQ(at[top], 10.0f);                  // west
    EXPECT_FLOAT_EQ(at[top + 1], 400.0f);             // high
    EXPECT_FLOAT_EQ(at[top + 2], -(640.0f - 10.0f));  // north
    const auto uv = glb.values<float>(glb.primitive().at("attributes").at("TEXCOORD_0"));
    EXPECT_FLOAT_EQ(uv[top / 3 * 2], 0.5f / 48.0f);
    EXPECT_FLOAT_EQ(uv[top / 3 * 2 + 1], 0.5f / 32.0f) << "the texture's top is north";
}

TEST(Gltf, FacesUpWithNormalsAndTangentsOfLengthOne) {
    const Terrain land = corner_land();
    const Parts glb(gltf_scene(land, shots_of(land), 512).file);
    const Json& attributes = glb.primitive().at("attributes");
    const auto p = glb.values<float>(attributes.at("POSITION"));
    const auto n = glb.values<float>(attributes.at("NORMAL"));
    const auto t = glb.values<float>(attributes.at("TANGENT"));
    const auto vec = [](const std::vector<float>& v, std::size_t i) {
        return Vec3{v[i], v[i + 1], v[i + 2]};
    };
    const auto indices = glb.values<std::uint32_t>(glb.primitive().at("indices"));
    EXPECT_EQ(indices.size(), 6u * 47 * 31);
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const Vec3 a = vec(p, 3 * indices[i]), b = vec(p, 3 * indices[i + 1]),
                   c = vec(p, 3 * indices[i + 2]);
        ASSERT_GT(cross(b - a, c - a).y, 0.0);
    }
    for (std::size_t i = 0; i < n.size() / 3; ++i) {
        const Vec3 normal = vec(n, 3 * i), tangent = vec(t, 4 * i);
        ASSERT_NEAR(length(normal), 1.0, 1e-5);
        ASSERT_NEAR(length(tangent), 1.0, 1e-5);
        ASSERT_NEAR(dot(normal, tangent), 0.0, 1e-5);
        // The third axis of the normal texture is north: up in the picture.
        ASSERT_LT(t[4 * i + 3] * cross(normal, tangent).z, 0.0);
    }
}

TEST(Gltf, TheSunShinesFromWhereItStands) {
    const Terrain land = corner_land();
    const GltfScene made = gltf_scene(land, shots_of(land), 512);
    const Parts glb(made.file);
    const char* kLights = "KHR_lights_punctual";
    EXPECT_EQ(glb.json.at("extensionsUsed"), Json::array({kLights}));
    const Json& light = glb.json.at("extensions").at(kLights).at("lights").at(0);
    EXPECT_EQ(light.at("type"), "directional");
    const auto colour = light.at("color").get<std::array<double, 3>>();
    for (const double c : colour) EXPECT_TRUE(c >= 0.0 && c <= 1.0) << c;
    EXPECT_GT(colour[0], colour[2]) << "a low sun is warm";
    EXPECT_NEAR(light.at("intensity").get<double>() *
                    (0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2]),
                made.lux, 1.0);
    EXPECT_GT(made.lux, 40e3);  // of 128,000 above the air
    EXPECT_LT(made.lux, 128e3);

    const Json& node = glb.node("sun");
    EXPECT_EQ(node.at("extensions").at(kLights).at("light"), 0);
    // A light shines along its own -z: from the south-west and above.
    const Vec3 shines = turned(node, {0.0, 0.0, -1.0});
    const Vec3 expected = in_gltf(-1.0 * direction_to({radians(215.0), radians(25.0)}));
    EXPECT_LT(length(shines - expected), 1e-9);
    EXPECT_GT(shines.x, 0.0);
    EXPECT_LT(shines.y, 0.0);
    EXPECT_LT(shines.z, 0.0);
}

TEST(Gltf, CamerasSeeWhatTheScenesSee) {
    const Terrain land = corner_land();
    const auto shots = shots_of(land);
    const Parts glb(gltf_scene(land, shots, 512).file);
    ASSERT_EQ(glb.json.at("cameras").size(), 2u);
    for (const Shot& shot : shots) {
        SCOPED_TRACE(shot.name);
        const Json& node = glb.node(shot.name);
        const CameraAxes axes(shot.camera);
        const auto eye = node.at("translation").get<std::array<double, 3>>();
        EXPECT_LT(length(Vec3{eye[0], eye[1], eye[2]} - in_gltf(axes.eye)), 1e-9);
        const auto expect_axis = [&](const Vec3& own, const Vec3& world) {
            EXPECT_LT(length(turned(node, own) - in_gltf(world)), 1e-9);
        };
        expect_axis({1.0, 0.0, 0.0}, axes.right);
        expect_axis({0.0, 1.0, 0.0}, axes.up);
        expect_axis({0.0, 0.0, -1.0}, axes.forward);
        const Json& camera = glb.json.at("cameras").at(node.at("camera").get<int>());
        const Json& kind = camera.at(camera.at("type").get<std::string>());
        EXPECT_GT(kind.at("znear").get<double>(), 0.0);
        EXPECT_GT(kind.at("zfar").get<double>(), kind.at("znear").get<double>());
    }
    const Json& map = glb.json.at("cameras").at(0);
    EXPECT_EQ(map.at("type"), "orthographic");
    const double half = 0.5 * shots[0].camera.frame_width;
    EXPECT_DOUBLE_EQ(map.at("orthographic").at("xmag").get<double>(), half);
    EXPECT_NEAR(map.at("orthographic").at("ymag").get<double>(), half * 108 / 192, 1e-9);
    const Json& view = glb.json.at("cameras").at(1).at("perspective");
    EXPECT_NEAR(view.at("aspectRatio").get<double>(), 16.0 / 9.0, 1e-12);
    EXPECT_NEAR(std::tan(0.5 * view.at("yfov").get<double>()) * 16.0 / 9.0,
                std::tan(0.5 * shots[1].camera.field_of_view), 1e-12);
}

TEST(Gltf, TurnsOfEveryKindAreQuaternions) {
    const Vec3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};
    for (const auto& [a, b, c] : {std::array{x, y, z},
                                  {y, z, x},
                                  {-1.0 * x, y, -1.0 * z},
                                  {x, -1.0 * y, -1.0 * z},
                                  {-1.0 * x, -1.0 * y, z},
                                  {z, x, y}}) {
        const Json node = {{"rotation", rotation_to(a, b, c)}};
        EXPECT_LT(length(turned(node, x) - a), 1e-12);
        EXPECT_LT(length(turned(node, y) - b), 1e-12);
        EXPECT_LT(length(turned(node, z) - c), 1e-12);
    }
}

// Where the mesh has all samples there is nothing left to add.
TEST(Gltf, NormalTextureHoldsOnlyWhatTheMeshLost) {
    const Terrain land = corner_land();
    for (const Rgb8& pixel : normals_in(Parts(gltf_scene(land, shots_of(land), 48).file)))
        for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(pixel[c], c == 2 ? 255 : 128, 1);
}

// A wall that faces east, too thin for the mesh: its east side leans to +x, red above the
// middle; one that faces north leans to +y, green.
TEST(Gltf, NormalTexturePointsEastInRedAndNorthInGreen) {
    Field<float> ridge(64, 64), coarse(2, 2);
    for (int y = 0; y < 64; ++y) ridge(32, y) = 40.0f;
    const Field<Rgb8> east = normal_map(ridge, coarse, 640.0, 640.0);
    EXPECT_GT(east(33, 20)[0], 200);
    EXPECT_LT(east(31, 20)[0], 56);
    EXPECT_NEAR(east(33, 20)[1], 128, 1);

    Field<float> wall(64, 64);
    for (int x = 0; x < 64; ++x) wall(x, 32) = 40.0f;
    const Field<Rgb8> north = normal_map(wall, coarse, 640.0, 640.0);
    EXPECT_GT(north(20, 31)[1], 200);  // the row north of it
    EXPECT_LT(north(20, 33)[1], 56);
}

// White where the land's north-western quarter is, black elsewhere.
TEST(Gltf, ColoursLieAsTheLandDoes) {
    Terrain land = corner_land();
    Field<float>& quarter = land.masks["quarter"] = Field<float>(48, 32);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 24; ++x) quarter(x, y) = 1.0f;
    auto shots = shots_of(land);
    Material black, white;
    black.light = black.dark = {0.01f, 0.01f, 0.01f};
    white.light = white.dark = {0.8f, 0.8f, 0.8f};
    Layer there;
    there.material = 1;
    there.mask = "quarter";
    shots[0].options.ground.look = {"test", {black, white}, {Layer{}, there}, {}, {}};

    const Parts glb(gltf_scene(land, shots, 512).file);
    const Json& image = glb.json.at("images").at(0);
    EXPECT_EQ(image.at("mimeType"), "image/jpeg");
    const Field<Rgb8> colours = picture_of(glb.view(image.at("bufferView")), "jpg");
    ASSERT_EQ(colours.width(), 4 * 48);
    ASSERT_EQ(colours.height(), 4 * 32);
    EXPECT_GT(colours(40, 30)[1], 180);  // sRGB: 0.8 of light is 231
    for (const auto& [x, y] : {std::pair{150, 30}, {40, 100}, {150, 100}})
        EXPECT_LT(colours(x, y)[1], 60) << x << ' ' << y;
}

TEST(Gltf, WaterIsASurfaceOfItsOwnWhereItIsWet) {
    Terrain land = corner_land();
    land.water = Field<float>(48, 32, kDry);
    for (int y = 0; y < 32; ++y)
        for (int x = 24; x < 48; ++x) land.water(x, y) = 60.0f;
    const Parts glb(gltf_scene(land, shots_of(land), 512).file);
    ASSERT_EQ(glb.json.at("meshes").size(), 2u);
    const Json& water = glb.json.at("meshes").at(1).at("primitives").at(0);
    const auto at = glb.values<float>(water.at("attributes").at("POSITION"));
    const auto indices = glb.values<std::uint32_t>(water.at("indices"));
    ASSERT_FALSE(indices.empty());
    int level = 0;
    for (const std::uint32_t i : indices) {
        EXPECT_GT(at[3 * i], 20.0f * 23.0f) << "west of the shore it is dry";
        level += std::abs(at[3 * i + 1] - 60.0f) < 0.01f;
    }
    EXPECT_GT(level, int(indices.size()) * 9 / 10);
    EXPECT_TRUE(Parts(gltf_scene(corner_land(), shots_of(land), 512).file)
                    .json.at("meshes")
                    .size() == 1u);
}

TEST(Gltf, AssimpReadsLandTexturesCamerasAndLight) {
    const Terrain land = corner_land();
    const auto shots = shots_of(land);
    const std::string glb = gltf_scene(land, shots, 24).file;
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFileFromMemory(
        glb.data(), glb.size(), aiProcess_ValidateDataStructure, "glb");
    ASSERT_TRUE(scene) << importer.GetErrorString();
    ASSERT_EQ(scene->mNumMeshes, 1u);
    const aiMesh& mesh = *scene->mMeshes[0];
    EXPECT_EQ(mesh.mNumVertices, 24u * 16);
    EXPECT_EQ(mesh.mNumFaces, 2u * 23 * 15);
    EXPECT_TRUE(mesh.HasNormals() && mesh.HasTangentsAndBitangents());
    EXPECT_EQ(scene->mNumTextures, 2u);
    unsigned top = 0;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i)
        if (mesh.mVertices[i].y > mesh.mVertices[top].y) top = i;
    EXPECT_LT(mesh.mVertices[top].x, 41.0f);
    EXPECT_LT(mesh.mVertices[top].z, -599.0f);
    ASSERT_EQ(scene->mNumCameras, 2u);
    EXPECT_STREQ(scene->mCameras[1]->mName.C_Str(), "view");
    EXPECT_NEAR(scene->mCameras[1]->mAspect, 16.0 / 9.0, 1e-5);
    EXPECT_NEAR(scene->mCameras[1]->mHorizontalFOV, shots[1].camera.field_of_view, 0.3);
    ASSERT_EQ(scene->mNumLights, 1u);
    EXPECT_EQ(scene->mLights[0]->mType, aiLightSource_DIRECTIONAL);
}

TEST(Gltf, TheSameBytesAgain) {
    const Terrain land = corner_land();
    EXPECT_EQ(gltf_scene(land, shots_of(land), 24).file,
              gltf_scene(land, shots_of(land), 24).file);
}

}  // namespace cydonia::render
