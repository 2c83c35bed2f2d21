#include "render/things/originals.h"

#include <cmath>
#include <map>
#include <numbers>

#include "field/random.h"
#include "field/sun.h"
#include "field/vec.h"

namespace cydonia::render {
namespace {

using Kind = ThingOptions::Kind;
using Part = Original::Part;

constexpr double kTurn = 2.0 * std::numbers::pi;

// The random numbers of one original, the same at every call.
class Draws {
  public:
    Draws(Kind kind, int number)
        : seed_(hash_of({key("things"), std::uint64_t(kind), std::uint64_t(number)})) {}
    double operator()() { return unit(hash_of({seed_, next_++})); }
    double operator()(double from, double to) { return from + (to - from) * (*this)(); }

  private:
    std::uint64_t seed_, next_ = 0;
};

Rgb varied(const Rgb& albedo, double by) {
    return {float(albedo[0] * by), float(albedo[1] * by), float(albedo[2] * by)};
}

std::uint32_t add(Part& part, double x, double y, double z) {
    part.vertices.push_back({float(x), float(y), float(z)});
    return std::uint32_t(part.vertices.size() - 1);
}

// A tapering stem between two points.
void add_stem(Part& part, Vec3 from, Vec3 to, double radius, double end_radius) {
    constexpr int kSides = 5;
    const std::uint32_t first = std::uint32_t(part.vertices.size());
    for (int i = 0; i < kSides; ++i) {
        const double a = kTurn * i / kSides, c = std::cos(a), s = std::sin(a);
        add(part, from.x + radius * c, from.y + radius * s, from.z);
        add(part, to.x + end_radius * c, to.y + end_radius * s, to.z);
    }
    for (std::uint32_t i = 0; i < kSides; ++i) {
        const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % kSides);
        part.triangles.push_back({a, b, a + 1});
        part.triangles.push_back({b, b + 1, a + 1});
    }
}

// A lump: an octahedron, subdivided `times` times, with each corner moved out or in.
void add_lump(Part& part, Vec3 centre, Vec3 radius, int times, double roughness,
              std::uint64_t seed) {
    std::vector<Vec3> corners{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                              {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    std::vector<std::array<std::uint32_t, 3>> faces{{0, 2, 4}, {2, 1, 4}, {1, 3, 4},
                                                    {3, 0, 4}, {2, 0, 5}, {1, 2, 5},
                                                    {3, 1, 5}, {0, 3, 5}};
    for (int t = 0; t < times; ++t) {
        std::map<std::array<std::uint32_t, 2>, std::uint32_t> halves;
        const auto half = [&](std::uint32_t a, std::uint32_t b) {
            const auto [it, fresh] = halves.try_emplace({std::min(a, b), std::max(a, b)},
                                                        std::uint32_t(corners.size()));
            if (fresh) corners.push_back(normalized(corners[a] + corners[b]));
            return it->second;
        };
        std::vector<std::array<std::uint32_t, 3>> finer;
        for (const auto& [a, b, c] : faces) {
            const std::uint32_t ab = half(a, b), bc = half(b, c), ca = half(c, a);
            finer.insert(finer.end(),
                         {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        faces = finer;
    }
    const std::uint32_t first = std::uint32_t(part.vertices.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double r = 1.0 + roughness * signed_unit(hash_of({seed, std::uint64_t(i)}));
        add(part, centre.x + r * radius.x * corners[i].x,
            centre.y + r * radius.y * corners[i].y,
            centre.z + r * radius.z * corners[i].z);
    }
    for (const auto& [a, b, c] : faces)
        part.triangles.push_back({first + a, first + b, first + c});
}

// Tiers of drooping branches around a stem, each a star of long and short ones.
Original conifer(Draws& draw) {
    Part wood{varied({0.070f, 0.050f, 0.035f}, draw(0.8, 1.2)), false, {}, {}};
    Part needles{varied({0.032f, 0.041f, 0.021f}, draw(0.65, 1.35)), false, {}, {}};
    const double width = draw(0.15, 0.21), bare = draw(0.05, 0.12);
    add_stem(wood, {0, 0, -0.03}, {0, 0, 0.9}, 0.018, 0.004);
    const int tiers = 9 + int(draw(0.0, 3.0));
    for (int i = 0; i < tiers; ++i) {
        const double t = double(i) / tiers;
        const double top = bare + (1.0 - bare) * (t + 1.45 / tiers);
        const double radius = width * std::pow(1.0 - t, 0.85) * draw(0.85, 1.1);
        const double edge = bare + (1.0 - bare) * t * 0.98;
        const int spikes = 7 + int(draw(0.0, 3.0));
        const double turn = kTurn * draw();
        const std::uint32_t tip = add(needles, 0, 0, std::min(top, 1.0));
        std::uint32_t first = tip + 1;
        for (int k = 0; k < 2 * spikes; ++k) {
            const double a = turn + kTurn * (k + draw(-0.2, 0.2)) / (2 * spikes);
            const double r = radius * (k % 2 ? draw(0.45, 0.6) : draw(0.85, 1.1));
            const double z = edge + (k % 2 ? 0.02 : -0.01) + draw(-0.008, 0.008);
            add(needles, r * std::cos(a), r * std::sin(a), z);
        }
        for (std::uint32_t k = 0; k < std::uint32_t(2 * spikes); ++k)
            needles.triangles.push_back(
                {tip, first + k, first + (k + 1) % std::uint32_t(2 * spikes)});
    }
    return {{wood, needles}};
}

// A stem, a few boughs and lumps of leaves around their ends.
Original broadleaf(Draws& draw) {
    Part wood{varied({0.085f, 0.066f, 0.048f}, draw(0.8, 1.2)), false, {}, {}};
    Part leaves{varied({0.058f, 0.076f, 0.030f}, draw(0.7, 1.3)), true, {}, {}};
    const double fork = draw(0.22, 0.32);
    add_stem(wood, {0, 0, -0.03}, {0, 0, fork}, 0.035, 0.022);
    const int boughs = 11;
    for (int i = 0; i < boughs; ++i) {
        const double a = kTurn * (0.618 * i + 0.05 * draw());
        const double t = (i + 0.5) / boughs;  // 0 at the foot of the crown, 1 at its top
        const double out =
            0.27 * std::sqrt(std::max(0.0, 1.0 - std::pow(2 * t - 0.8, 2)));
        const Vec3 end{out * std::cos(a), out * std::sin(a), fork + 0.12 + 0.5 * t};
        add_stem(wood, {0, 0, fork}, end, 0.012, 0.004);
        const double r = draw(0.13, 0.18) * (1.0 - 0.25 * t);
        add_lump(leaves, end, {r, r, 0.8 * r}, 2, 0.22, std::uint64_t(1e9 * draw()));
    }
    return {{wood, leaves}};
}

Original shrub(Draws& draw) {
    Part leaves{varied({0.050f, 0.066f, 0.026f}, draw(0.7, 1.3)), false, {}, {}};
    for (int i = 0; i < 5; ++i) {
        const double a = kTurn * draw(), r = i ? draw(0.25, 0.5) : 0.0;
        const double size = draw(0.3, 0.5);
        add_lump(leaves, {r * std::cos(a), r * std::sin(a), 0.75 * size},
                 {size, size, 0.8 * size}, 1, 0.35, std::uint64_t(1e9 * draw()));
    }
    return {{leaves}};
}

// Bent blades, wider than real ones so that they cover pixels.
Original grass(Draws& draw) {
    Part blades{varied({0.13f, 0.14f, 0.045f}, draw(0.75, 1.25)), false, {}, {}};
    for (int i = 0; i < 24; ++i) {
        const double a = kTurn * draw(), lean = draw(0.1, 0.7), high = draw(0.55, 1.0);
        const double c = std::cos(a), s = std::sin(a), foot = draw(0.0, 0.22), w = 0.025;
        const auto at = [&](double out, double side, double z) {
            return add(blades, (foot + out) * c - side * s, (foot + out) * s + side * c,
                       z);
        };
        const std::uint32_t l = at(0, -w, -0.02), r = at(0, w, -0.02),
                            ml = at(0.35 * lean, -0.7 * w, 0.6 * high),
                            mr = at(0.35 * lean, 0.7 * w, 0.6 * high),
                            tip = at(lean, 0, high);
        blades.triangles.insert(blades.triangles.end(),
                                {{l, r, ml}, {r, mr, ml}, {ml, mr, tip}});
    }
    return {{blades}};
}

// A stone: a lump cut by a few planes, as joints cut rock.
Original rock(Draws& draw, double angular) {
    Part stone{varied({0.19f, 0.175f, 0.155f}, draw(0.75, 1.2)), false, {}, {}};
    add_lump(stone, {0, 0, 0}, {draw(0.6, 0.95), draw(0.5, 0.8), draw(0.4, 0.6)}, 3, 0.07,
             std::uint64_t(1e9 * draw()));
    for (int i = 0; i < 9; ++i) {
        const double a = kTurn * draw(), z = draw(-0.3, 1.0);
        const double c = std::sqrt(1.0 - z * z);
        const Vec3 n{c * std::cos(a), c * std::sin(a), z};
        const double reach = draw(0.38, 0.62) / angular;
        for (auto& v : stone.vertices) {
            const double over = n.x * v[0] + n.y * v[1] + n.z * v[2] - reach;
            if (over <= 0.0) continue;
            v = {float(v[0] - over * n.x), float(v[1] - over * n.y),
                 float(v[2] - over * n.z)};
        }
    }
    float low = 0.0f;
    for (const auto& v : stone.vertices) low = std::min(low, v[2]);
    for (auto& v : stone.vertices) v[2] -= low;
    return {{stone}};
}

Original grown(Kind kind, Draws& draw) {
    switch (kind) {
        case Kind::kConifer:
            return conifer(draw);
        case Kind::kBroadleaf:
            return broadleaf(draw);
        case Kind::kShrub:
            return shrub(draw);
        case Kind::kGrass:
            return grass(draw);
        case Kind::kRock:
            return rock(draw, 1.1);
        case Kind::kBoulder:
            break;
    }
    return rock(draw, 0.9);
}

}  // namespace

std::vector<std::array<float, 3>> normals_of(const Original::Part& part) {
    std::vector<Vec3> sums(part.vertices.size());
    const auto at = [&](std::uint32_t i) {
        return Vec3{part.vertices[i][0], part.vertices[i][1], part.vertices[i][2]};
    };
    for (const auto& [a, b, c] : part.triangles) {
        const Vec3 n = cross(at(b) - at(a), at(c) - at(a));
        for (const std::uint32_t i : {a, b, c}) sums[i] = sums[i] + n;
    }
    std::vector<std::array<float, 3>> normals;
    for (const Vec3& sum : sums) {
        const Vec3 n = normalized(sum);
        normals.push_back({float(n.x), float(n.y), float(n.z)});
    }
    return normals;
}

Original original_of(Kind kind, int number) {
    Draws draw(kind, number);
    Original original = grown(kind, draw);
    float high = 0.0f;
    for (const Part& part : original.parts)
        for (const auto& v : part.vertices) high = std::max(high, v[2]);
    for (Part& part : original.parts)
        for (auto& v : part.vertices)
            for (float& c : v) c /= high;
    return original;
}

const Habit& habit_of(Kind kind) {
    static constexpr Habit kHabits[] = {
        {350.0, {7.0, 24.0}, {radians(32.0), radians(46.0)}, 0.0},  // conifer
        {160.0, {6.0, 18.0}, {radians(22.0), radians(36.0)}, 0.0},  // broadleaf
        {500.0, {0.5, 2.2}, {radians(30.0), radians(44.0)}, 0.1},   // shrub
        {8000.0, {0.2, 0.6}, {radians(26.0), radians(40.0)}, 0.0},  // grass
        {400.0, {0.2, 1.2}, {radians(34.0), radians(42.0)}, 0.3},   // rock
        {12.0, {1.0, 5.0}, {radians(30.0), radians(38.0)}, 0.25},   // boulder
    };
    return kHabits[static_cast<int>(kind)];
}

}  // namespace cydonia::render
