#include "render/shadow/caster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "field/error.h"
#include "field/parallel.h"
#include "render/embree/embree.h"

namespace cydonia::render {

namespace {

static_assert(kLargestSide <= 32767);  // as many samples a side has an Embree grid
constexpr std::size_t kMaxSamples = std::size_t{1} << 32;
constexpr int kTile = 4;  // 4x4 neighbouring samples are one packet of rays

// Coordinates are cells east, north and up from the middle of the land, where floats are
// most precise.
using embree::Vertex;
using embree::vertex;

// The position of a row or column of samples on the mesh: in the square after sample
// `cell`, at the share `at` (0 to 1) of the way to the next.
struct Stop {
    int cell;
    float at;
};

// The stops of all sample rows or columns along an axis of `count` cells, computed in
// whole parts of a cell, so that samples on lines are exactly on them. Such a sample
// belongs to the later square if `forward`.
std::vector<Stop> stops(int count, int rays, bool forward) {
    const int cell = 2 * rays, last = cell * (count - 1);
    std::vector<Stop> result;
    result.reserve(static_cast<std::size_t>(count) * rays);
    for (int i = 0; i < count * rays; ++i) {
        const int at = std::clamp(2 * i + 1 - rays, 0, last);
        const int square = std::clamp((forward ? at : at - 1) / cell, 0, count - 2);
        result.push_back(
            {square, static_cast<float>(at - square * cell) / static_cast<float>(cell)});
    }
    return result;
}

Error no_memory(int width, int height) {
    return failure("not enough memory to cast the shadows of {}x{} heights", width,
                   height);
}

// The samples of a cast, and the unit vector to the sun.
struct Samples {
    std::vector<Stop> columns, rows;
    Vertex sun;
};

// The origin of a sample's ray, and whether its triangle faces the sun.
struct Start {
    Vertex at;
    bool faces_sun;
};

void check_request(const Field<float>& heights, double spacing) {
    const int w = heights.width(), h = heights.height();
    if (std::min(w, h) < 2 || std::max(w, h) > kLargestSide)
        throw bad_request("shadows need 2x2 to {0}x{0} heights, not {1}x{2}",
                          kLargestSide, w, h);
    if (!(spacing > 0.0) || !std::isfinite(spacing))
        throw bad_request("shadows need a cell size above 0 m, not {}", spacing);
    for (std::size_t i = 0; i < heights.size(); ++i)
        if (!std::isfinite(heights[i]))
            throw bad_request(
                "the height at column {}, row {} is not a number: fill the "
                "voids first",
                i % static_cast<std::size_t>(w), i / static_cast<std::size_t>(w));
}

// Whether any cell of the tile of samples at (x, y) is wanted.
bool wanted(const Field<std::uint8_t>& where, int x, int y, int rays) {
    if (where.empty()) return true;
    const int east = std::min((x + kTile - 1) / rays, where.width() - 1);
    const int south = std::min((y + kTile - 1) / rays, where.height() - 1);
    for (int j = y / rays; j <= south; ++j)
        for (int i = x / rays; i <= east; ++i)
            if (where(i, j)) return true;
    return false;
}

}  // namespace

struct Caster::Scene {
    Scene(const Field<float>& heights, double spacing);

    void lay_grid(const Field<float>& heights, double spacing);
    // Vertices are stored from the south row to the north; y counts from the north, as in
    // fields.
    const Vertex* row(int y) const {
        return vertices + static_cast<std::size_t>(height - 1 - y) * width;
    }
    Start start(Stop column, Stop line, Vertex sun) const;
    void cast_tile(int x0, int y0, const Samples& samples,
                   Field<std::uint8_t>& shadow) const;

    int width, height;
    embree::Device device;
    embree::Scene scene;
    const Vertex* vertices = nullptr;  // owned by the geometry
    float lift = 0.0f;                 // how far above the mesh rays start
};

Caster::Scene::Scene(const Field<float>& heights, double spacing)
    : width(heights.width()),
      height(heights.height()),
      device(rtcNewDevice(nullptr)),
      scene(embree::new_scene(device)) {
    lay_grid(heights, spacing);
    rtcCommitScene(scene.get());
    if (rtcGetDeviceError(device.get()) != RTC_ERROR_NONE) throw no_memory(width, height);
}

void Caster::Scene::lay_grid(const Field<float>& heights, double spacing) {
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    const double middle = 0.5 * (static_cast<double>(*low) + *high);
    vertices = embree::lay_grid(device, scene, width, height, [&](Vertex* laid) {
        parallel_for(height, 16, [&](int y) {
            Vertex* out = laid + static_cast<std::size_t>(height - 1 - y) * width;
            for (int x = 0; x < width; ++x)
                out[x] = vertex({x - 0.5 * (width - 1), 0.5 * (height - 1) - y,
                                 (heights(x, y) - middle) / spacing});
        });
    });
    if (!vertices) throw no_memory(width, height);
    // A few rounding steps of a float at the mesh's far end; a quarter of this is the
    // least that keeps planes from shadowing themselves.
    const double reach =
        std::max({0.5 * width, 0.5 * height, (*high - middle) / spacing});
    lift = static_cast<float>(4.0 * reach * std::numeric_limits<float>::epsilon());
}

Start Caster::Scene::start(Stop column, Stop line, Vertex sun) const {
    const Vertex* north = row(line.cell) + column.cell;
    const Vertex* south = row(line.cell + 1) + column.cell;
    const float nw = north[0].z, ne = north[1].z, sw = south[0].z, se = south[1].z;
    const float u = column.at, v = line.at;
    // The square's NW-SE diagonal is u = v. Samples on it, which are half of those at 2x2
    // a cell, belong to the north-east triangle, as in POV-Ray. Samples on corners and on
    // all other lines belong to the side of the sun, so that crests are lit.
    const bool corner = u == 0.0f || u == 1.0f;
    const bool north_east = u > v || (u == v && (!corner || sun.x + sun.y > 0.0f));
    const float rise_u = north_east ? ne - nw : se - sw;
    const float rise_v = north_east ? se - ne : sw - nw;
    return {{north->x + u, north->y - v, nw + u * rise_u + v * rise_v + lift},
            sun.z - rise_u * sun.x + rise_v * sun.y > 0.0f};
}

void Caster::Scene::cast_tile(int x0, int y0, const Samples& samples,
                              Field<std::uint8_t>& shadow) const {
    constexpr int kRays = kTile * kTile;
    alignas(64) RTCRay16 rays{};
    alignas(64) std::array<int, kRays> faces_sun{};
    const int columns = std::min(kTile, shadow.width() - x0);
    const int rows = std::min(kTile, shadow.height() - y0);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const Start from =
                start(samples.columns[x0 + x], samples.rows[y0 + y], samples.sun);
            const int i = y * kTile + x;
            rays.org_x[i] = from.at.x;
            rays.org_y[i] = from.at.y;
            rays.org_z[i] = from.at.z;
            faces_sun[i] = from.faces_sun ? -1 : 0;
        }
    std::fill_n(rays.dir_x, kRays, samples.sun.x);
    std::fill_n(rays.dir_y, kRays, samples.sun.y);
    std::fill_n(rays.dir_z, kRays, samples.sun.z);
    std::fill_n(rays.tfar, kRays, std::numeric_limits<float>::infinity());
    std::fill_n(rays.mask, kRays, ~0u);
    embree::mark_occluded(scene.get(), faces_sun.data(), rays);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const int i = y * kTile + x;
            shadow(x0 + x, y0 + y) = !faces_sun[i] || rays.tfar[i] < 0.0f;
        }
}

Caster::Caster(const Field<float>& heights, double spacing) {
    check_request(heights, spacing);
    scene_ = std::make_unique<Scene>(heights, spacing);
}
Caster::~Caster() = default;
Caster::Caster(Caster&&) noexcept = default;
Caster& Caster::operator=(Caster&&) noexcept = default;

Field<std::uint8_t> Caster::shadow(const Sun& sun, int rays) const {
    return shadow(sun, rays, {});
}

Field<std::uint8_t> Caster::shadow(const Sun& sun, int rays,
                                   const Field<std::uint8_t>& where) const {
    const int w = scene_->width, h = scene_->height;
    if (!where.empty() && (where.width() != w || where.height() != h))
        throw bad_request("a mask of {}x{} cells does not fit {}x{} heights",
                          where.width(), where.height(), w, h);
    const Vec3 to_sun = direction_to(sun);
    if (!(to_sun.z > 0.0))
        throw bad_request(
            "the sun stands {:.1f} degrees above the horizon: it must be up",
            degrees(sun.elevation));
    const std::size_t cells = static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
    if (rays < 1 || rays > 64 || cells * rays * rays > kMaxSamples)
        throw bad_request("{0}x{0} rays a cell are too many for {1}x{2} heights", rays, w,
                          h);
    const Samples samples{stops(w, rays, to_sun.x >= 0.0), stops(h, rays, to_sun.y < 0.0),
                          vertex(to_sun)};
    Field<std::uint8_t> shadow(w * rays, h * rays);
    parallel_for((shadow.height() + kTile - 1) / kTile, [&](int band) {
        for (int x = 0; x < shadow.width(); x += kTile)
            if (wanted(where, x, band * kTile, rays))
                scene_->cast_tile(x, band * kTile, samples, shadow);
    });
    return shadow;
}

}  // namespace cydonia::render
