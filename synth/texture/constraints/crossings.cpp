#include "synth/texture/constraints/crossings.h"

#include <optional>
#include <tuple>

#include "field/error.h"
#include "synth/geometry/nearest.h"

namespace cydonia::texture {

using namespace geometry;

namespace {

// A line of a curve, or, with no length, a point constraint or a free end of a curve.
struct Piece {
    int owner, segment;
    Point2 a, b;
    double along, length;
    bool dot;
    Box box;
};

void add_dot(std::vector<Piece>& pieces, int owner, int segment, const Point2& at,
             double along, double near) {
    pieces.push_back(
        {owner, segment, at, at, along, 0.0, true, Box::of(at, at).grown(near)});
}

std::vector<Piece> pieces_of(const std::vector<PointConstraint>& points,
                             const std::vector<CurveConstraint>& curves, double near) {
    std::vector<Piece> pieces;
    int owner = 0;
    for (const PointConstraint& point : points)
        add_dot(pieces, owner++, -1, point.at, 0.0, near);
    for (const CurveConstraint& curve : curves) {
        const Shape& shape = curve.shape;
        for (int s = 0; s < shape.segments(); ++s) {
            const Point2 &a = shape.points[s], &b = shape.points[s + 1];
            pieces.push_back({owner, s, a, b, shape.along[s],
                              shape.along[s + 1] - shape.along[s], false, Box::of(a, b)});
        }
        if (!shape.closed) {
            add_dot(pieces, owner, 0, shape.points.front(), 0.0, near);
            add_dot(pieces, owner, shape.segments() - 1, shape.points.back(),
                    shape.length(), near);
        }
        ++owner;
    }
    // A stable sort, so that the order of equal ones is always the same.
    std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& p, const Piece& q) {
        return p.box.west < q.box.west;
    });
    return pieces;
}

Crossing crossing_at(const Piece& p, double on_p, const Piece& q, double on_q) {
    const double along_p = p.along + on_p * p.length, along_q = q.along + on_q * q.length;
    const Point2 at = between(p.a, p.b, on_p);
    if (std::tie(p.owner, along_p) <= std::tie(q.owner, along_q))
        return {p.owner, q.owner, {along_p, along_q}, at};
    return {q.owner, p.owner, {along_q, along_p}, at};
}

// The crossing where `dot` is near a line or another dot.
std::optional<Crossing> touching(const Piece& dot, const Piece& other, double near) {
    const double share = other.dot ? 0.0 : nearest_share(other.a, other.b, dot.a);
    if (distance(dot.a, between(other.a, other.b, share)) > near) return std::nullopt;
    return crossing_at(dot, 0.0, other, share);
}

std::optional<Crossing> crossing(const Piece& p, const Piece& q) {
    const Point2 d = from_to(p.a, p.b), e = from_to(q.a, q.b), v = from_to(p.a, q.a);
    const double area = cross(d, e);
    if (std::abs(area) < 1e-12 * p.length * q.length) return std::nullopt;  // parallel
    const double t = cross(v, e) / area, u = cross(v, d) / area;
    if (t < 0.0 || t > 1.0 || u < 0.0 || u > 1.0) return std::nullopt;
    return crossing_at(p, t, q, u);
}

// Whether a crossing is more than one point of a curve with itself.
bool apart(const Crossing& m, const std::vector<CurveConstraint>& curves,
           std::size_t points, double cell) {
    if (m.first != m.second) return true;
    const Shape& shape = curves[std::size_t(m.second) - points].shape;
    const double between = m.along[1] - m.along[0];
    return between > 2.0 * cell &&
           !(shape.closed && between > shape.length() - 2.0 * cell);
}

bool before(const Crossing& m, const Crossing& n) {
    return std::tie(m.second, m.along[1], m.first, m.along[0]) <
           std::tie(n.second, n.along[1], n.first, n.along[0]);
}

// Keeps one of all crossings of the same two constraints within a cell.
std::vector<Crossing> merged(const std::vector<Crossing>& sorted, double cell) {
    std::vector<Crossing> kept;
    for (const Crossing& m : sorted) {
        bool known = false;
        for (auto k = kept.rbegin();
             k != kept.rend() && k->second == m.second && m.along[1] - k->along[1] < cell;
             ++k)
            known |= k->first == m.first && std::abs(m.along[0] - k->along[0]) < cell;
        if (!known) kept.push_back(m);
    }
    return kept;
}

}  // namespace

std::vector<Crossing> crossings_of(const std::vector<PointConstraint>& points,
                                   const std::vector<CurveConstraint>& curves,
                                   double cell) {
    const double near = 0.5 * cell;
    const std::vector<Piece> pieces = pieces_of(points, curves, near);
    std::vector<Crossing> found;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (std::size_t j = i + 1;
             j < pieces.size() && pieces[j].box.west <= pieces[i].box.east; ++j) {
            const Piece &p = pieces[i], &q = pieces[j];
            if (!p.box.touches(q.box)) continue;
            if (p.owner == q.owner && std::abs(p.segment - q.segment) < 2) continue;
            const auto m = p.dot   ? touching(p, q, near)
                           : q.dot ? touching(q, p, near)
                                   : crossing(p, q);
            if (!m || !apart(*m, curves, points.size(), cell)) continue;
            found.push_back(*m);
            if (found.size() > kMostCrossings)
                throw bad_request("curves cross more than {} times: draw fewer of them",
                                  kMostCrossings);
        }
    std::sort(found.begin(), found.end(), before);
    return merged(found, cell);
}

}  // namespace cydonia::texture
