#include "field/svg_path_data.h"

#include <cctype>
#include <numbers>

#include "field/error.h"
#include "field/svg_text.h"
#include "field/vec.h"

namespace cydonia {
namespace {

constexpr std::size_t kMostCurves = 1'000'000;

Point2 operator+(const Point2& a, const Point2& b) { return {a[0] + b[0], a[1] + b[1]}; }
Point2 operator-(const Point2& a, const Point2& b) { return {a[0] - b[0], a[1] - b[1]}; }
Point2 operator*(double s, const Point2& a) { return {s * a[0], s * a[1]}; }

Point2 end_of(const SvgOutline& outline) {
    return outline.curves.empty() ? outline.start : outline.curves.back()[2];
}

// Follows the commands of one path.
class PathReader {
  public:
    explicit PathReader(std::string_view data) : reader_(data) {}

    std::vector<SvgOutline> outlines() {
        while (!reader_.done()) {
            if (const auto letter = reader_.letter())
                next(*letter);
            else if (command_ == 'M' || command_ == 'm')
                next(command_ == 'M' ? 'L' : 'l');  // more points are lines
            else if (command_ != 0 && !closing())
                next(command_);
            else
                fail();
            if (++count_ > kMostCurves)
                throw bad_request("a path of more than {} pieces", kMostCurves);
        }
        return std::move(outlines_);
    }

  private:
    [[noreturn]] void fail() {
        throw bad_request("a path cannot be read from '{}' on",
                          reader_.rest().substr(0, 20));
    }
    bool closing() const { return command_ == 'Z' || command_ == 'z'; }
    double number() {
        const auto value = reader_.number();
        if (!value) fail();
        return *value;
    }
    bool flag() {
        const auto value = reader_.flag();
        if (!value) fail();
        return *value;
    }
    Point2 here() const { return end_of(outlines_.back()); }
    // The next point: relative to where the command began if that is a small letter.
    Point2 point() {
        const double x = number(), y = number();
        const bool relative = std::islower(command_) && !outlines_.empty();
        return relative ? from_ + Point2{x, y} : Point2{x, y};
    }
    void curve(const Point2& c1, const Point2& c2, const Point2& to) {
        outlines_.back().curves.push_back({c1, c2, to});
    }
    void quadratic(const Point2& c, const Point2& to) {
        curve(1.0 / 3.0 * from_ + 2.0 / 3.0 * c, 1.0 / 3.0 * to + 2.0 / 3.0 * c, to);
    }
    // The mirrored last handle of the curve before, if that was of the same kind.
    Point2 mirrored(std::string_view kinds, const Point2& handle) const {
        const bool smooth = kinds.find(before_) != std::string_view::npos;
        return smooth ? 2.0 * from_ - handle : from_;
    }

    void next(char command) {
        before_ = char(std::toupper(command_));
        command_ = command;
        const char kind = char(std::toupper(command));
        if (kind != 'M' && outlines_.empty()) fail();
        if (kind != 'M' && kind != 'Z' && outlines_.back().closed)
            outlines_.push_back({outlines_.back().start, {}, false});
        if (!outlines_.empty())
            from_ = outlines_.back().closed ? outlines_.back().start : here();
        follow(kind);
    }

    void follow(char kind) {
        switch (kind) {
            case 'M': {
                const Point2 start = point();
                outlines_.push_back({start, {}, false});
                break;
            }
            case 'L':
                add_line(outlines_.back(), point());
                break;
            case 'H':
                across(0);
                break;
            case 'V':
                across(1);
                break;
            case 'C': {
                const Point2 c1 = point();
                cubic(c1);
                break;
            }
            case 'S':
                cubic(mirrored("CS", handle_));
                break;
            case 'Q':
                handle_ = point();
                quadratic(handle_, point());
                break;
            case 'T':
                handle_ = mirrored("QT", handle_);
                quadratic(handle_, point());
                break;
            case 'A':
                arc();
                break;
            case 'Z':
                close();
                break;
            default:
                fail();
        }
    }

    void across(int axis) {
        Point2 to = from_;
        const double value = number();
        to[axis] = std::islower(command_) ? from_[axis] + value : value;
        add_line(outlines_.back(), to);
    }
    void cubic(const Point2& c1) {
        handle_ = point();
        curve(c1, handle_, point());
    }
    void arc() {
        const double rx = number(), ry = number(), turn = number();
        const bool large = flag(), sweep = flag();
        add_arc(outlines_.back(), {rx, ry}, turn, large, sweep, point());
    }
    void close() {
        SvgOutline& outline = outlines_.back();
        if (!outline.closed && here() != outline.start) add_line(outline, outline.start);
        outline.closed = true;
    }

    NumberReader reader_;
    std::vector<SvgOutline> outlines_;
    char command_ = 0, before_ = 0;
    Point2 from_{};    // where the pen was when the command began
    Point2 handle_{};  // the last one of the curve before
    std::size_t count_ = 0;
};

double angle_of(const Point2& v) { return std::atan2(v[1], v[0]); }

// The centre of the ellipse through a and b, in coordinates in which it is the unit
// circle. An ellipse that is too small is enlarged.
Point2 middle_of(Point2& a, Point2& b, Point2& r, bool other_side) {
    const Point2 half = 0.5 * (b - a);
    const double grown = std::hypot(half[0], half[1]);
    if (grown > 1.0) {
        a = 1.0 / grown * a;
        b = 1.0 / grown * b;
        r = grown * r;
        return 0.5 * (a + b);
    }
    const double up = std::sqrt(1.0 / (grown * grown) - 1.0) * (other_side ? -1.0 : 1.0);
    return 0.5 * (a + b) + up * Point2{-half[1], half[0]};
}

}  // namespace

void add_line(SvgOutline& outline, const Point2& to) {
    const Point2 from = end_of(outline);
    const Point2 third = 1.0 / 3.0 * (to - from);
    outline.curves.push_back({from + third, to - third, to});
}

void add_arc(SvgOutline& outline, Point2 r, double turn, bool large, bool sweep,
             const Point2& to) {
    const Point2 from = end_of(outline);
    r = {std::abs(r[0]), std::abs(r[1])};
    if (from == to) return;
    if (r[0] == 0.0 || r[1] == 0.0) return add_line(outline, to);
    const double c = std::cos(radians(turn)), s = std::sin(radians(turn));
    const auto to_circle = [&](const Point2& p) {
        return Point2{(c * p[0] + s * p[1]) / r[0], (c * p[1] - s * p[0]) / r[1]};
    };
    Point2 a = to_circle(from), b = to_circle(to);
    const Point2 middle = middle_of(a, b, r, large == sweep);
    const double begin = angle_of(a - middle);
    double swept = angle_of(b - middle) - begin;
    if (sweep && swept < 0.0) swept += 2.0 * std::numbers::pi;
    if (!sweep && swept > 0.0) swept -= 2.0 * std::numbers::pi;

    const Affine ellipse{c * r[0], s * r[0], -s * r[1], c * r[1], 0.0, 0.0};
    const int pieces = std::max(1, int(std::ceil(std::abs(swept) / 1.6)));
    const double step = swept / pieces, reach = 4.0 / 3.0 * std::tan(step / 4.0);
    for (int i = 0; i < pieces; ++i) {
        const double t0 = begin + i * step, t1 = t0 + step;
        const Point2 p0{std::cos(t0), std::sin(t0)}, p1{std::cos(t1), std::sin(t1)};
        outline.curves.push_back({ellipse(middle + p0 + reach * Point2{-p0[1], p0[0]}),
                                  ellipse(middle + p1 - reach * Point2{-p1[1], p1[0]}),
                                  i + 1 < pieces ? ellipse(middle + p1) : to});
    }
}

std::vector<SvgOutline> outlines_of(std::string_view data) {
    return PathReader(data).outlines();
}

}  // namespace cydonia
