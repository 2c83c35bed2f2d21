#include "render/gltf/glb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

namespace cydonia::render {
namespace {

// Constants of glTF (sections 3.6.2 and 5.26).
constexpr int kFloat = 5126, kUnsigned = 5125;
constexpr int kVertices = 34962, kIndices = 34963;
constexpr int kLinear = 9729, kLinearMipmapped = 9987, kClamped = 33071;

// The bytes as they are in memory: the format and all supported processors are
// little-endian.
template <class T>
std::string_view bytes_of(std::span<const T> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

void append(std::string& bytes, std::uint32_t value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
}

void fill_to_four(std::string& bytes, char with) {
    bytes.resize((bytes.size() + 3) / 4 * 4, with);
}

}  // namespace

int Glb::add(const char* array, Json item) {
    json[array].push_back(std::move(item));
    return static_cast<int>(json[array].size()) - 1;
}

int Glb::view(std::string_view bytes, int target) {
    fill_to_four(buffer_, '\0');
    Json view = {
        {"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
    if (target != 0) view["target"] = target;
    buffer_ += bytes;
    return add("bufferViews", std::move(view));
}

int Glb::attribute(std::span<const float> values, int width) {
    const auto n = static_cast<std::size_t>(width);
    std::vector<float> low(values.begin(), values.begin() + width), high = low;
    for (std::size_t i = 0; i < values.size(); ++i) {
        low[i % n] = std::min(low[i % n], values[i]);
        high[i % n] = std::max(high[i % n], values[i]);
    }
    constexpr const char* kTypes[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
    return add("accessors", {{"bufferView", view(bytes_of(values), kVertices)},
                             {"componentType", kFloat},
                             {"count", values.size() / n},
                             {"type", kTypes[width - 1]},
                             {"min", low},
                             {"max", high}});
}

int Glb::indices(std::span<const std::uint32_t> values) {
    return add("accessors", {{"bufferView", view(bytes_of(values), kIndices)},
                             {"componentType", kUnsigned},
                             {"count", values.size()},
                             {"type", "SCALAR"}});
}

int Glb::image(std::string_view bytes, const char* mime_type) {
    return add("images", {{"bufferView", view(bytes, 0)}, {"mimeType", mime_type}});
}

int Glb::texture(int image) {
    if (!json.contains("samplers"))
        add("samplers", {{"magFilter", kLinear},
                         {"minFilter", kLinearMipmapped},
                         {"wrapS", kClamped},
                         {"wrapT", kClamped}});
    return add("textures", {{"sampler", 0}, {"source", image}});
}

std::string Glb::file() {
    fill_to_four(buffer_, '\0');
    json["buffers"] = {{{"byteLength", buffer_.size()}}};
    std::string text = json.dump();
    fill_to_four(text, ' ');

    std::string bytes = "glTF";
    bytes.reserve(28 + text.size() + buffer_.size());
    append(bytes, 2);
    append(bytes, static_cast<std::uint32_t>(28 + text.size() + buffer_.size()));
    append(bytes, static_cast<std::uint32_t>(text.size()));
    bytes += "JSON";
    bytes += text;
    append(bytes, static_cast<std::uint32_t>(buffer_.size()));
    bytes += std::string_view("BIN\0", 4);
    bytes += buffer_;
    return bytes;
}

// The quaternion of a rotation matrix with these columns, computed from its largest
// component (Shepperd 1978).
std::array<double, 4> rotation_to(const Vec3& x, const Vec3& y, const Vec3& z) {
    const double trace = x.x + y.y + z.z;
    const std::array<double, 4> squares{1.0 + 2.0 * x.x - trace, 1.0 + 2.0 * y.y - trace,
                                        1.0 + 2.0 * z.z - trace, 1.0 + trace};
    const auto largest = std::ranges::max_element(squares) - squares.begin();
    const double l = std::sqrt(
        squares[static_cast<std::size_t>(largest)]);  // twice the largest component
    const double s = 0.5 / l;
    switch (largest) {
        case 0:
            return {0.5 * l, s * (x.y + y.x), s * (z.x + x.z), s * (y.z - z.y)};
        case 1:
            return {s * (x.y + y.x), 0.5 * l, s * (y.z + z.y), s * (z.x - x.z)};
        case 2:
            return {s * (z.x + x.z), s * (y.z + z.y), 0.5 * l, s * (x.y - y.x)};
        default:
            return {s * (y.z - z.y), s * (z.x - x.z), s * (x.y - y.x), 0.5 * l};
    }
}

}  // namespace cydonia::render
