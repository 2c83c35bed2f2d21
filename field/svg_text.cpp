#include "field/svg_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "field/vec.h"

namespace cydonia {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\f";

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

Affine rotation(double angle) {
    return {std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle), 0, 0};
}

// The transform of one function with its arguments.
std::optional<Affine> transform_of(std::string_view name, const std::vector<double>& v) {
    const std::size_t n = v.size();
    if (name == "matrix" && n == 6) return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
    if (name == "translate" && (n == 1 || n == 2))
        return Affine{1, 0, 0, 1, v[0], n == 2 ? v[1] : 0.0};
    if (name == "scale" && (n == 1 || n == 2)) return Affine{v[0], 0, 0, v[n - 1], 0, 0};
    if (name == "rotate" && n == 1) return rotation(radians(v[0]));
    if (name == "rotate" && n == 3)
        return Affine{1, 0, 0, 1, v[1], v[2]} * rotation(radians(v[0])) *
               Affine{1, 0, 0, 1, -v[1], -v[2]};
    if (name == "skewX" && n == 1) return Affine{1, 0, std::tan(radians(v[0])), 1, 0, 0};
    if (name == "skewY" && n == 1) return Affine{1, std::tan(radians(v[0])), 0, 1, 0, 0};
    return std::nullopt;
}

// The offset of a length `inside` within `whole`; "xMid" in `aspect` centres it.
double aligned(std::string_view aspect, char axis, double whole, double inside) {
    const std::size_t at = aspect.find(axis);
    const std::string_view how =
        at == std::string_view::npos ? "Mid" : aspect.substr(at + 1, 3);
    return (how == "Min" ? 0.0 : how == "Max" ? 1.0 : 0.5) * (whole - inside);
}

}  // namespace

void NumberReader::skip_blanks(bool and_comma) {
    for (; !rest_.empty(); rest_.remove_prefix(1)) {
        if (kBlanks.find(rest_[0]) != std::string_view::npos) continue;
        if (!and_comma || rest_[0] != ',') return;
        and_comma = false;
    }
}

bool NumberReader::done() {
    skip_blanks(true);
    return rest_.empty();
}

std::optional<double> NumberReader::number() {
    skip_blanks(true);
    // from_chars() refuses a plus sign, but accepts names such as "inf" that SVG does not
    // know.
    std::string_view text = rest_;
    if (text.starts_with('+')) text.remove_prefix(1);
    const std::size_t first = text.find_first_not_of("-");
    if (first == std::string_view::npos || is_letter(text[first])) return std::nullopt;
    double value = 0.0;
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
}

std::optional<bool> NumberReader::flag() {
    skip_blanks(true);
    if (!rest_.starts_with('0') && !rest_.starts_with('1')) return std::nullopt;
    const bool value = rest_[0] == '1';
    rest_.remove_prefix(1);
    return value;
}

std::optional<char> NumberReader::letter() {
    skip_blanks(true);
    if (rest_.empty() || !is_letter(rest_[0])) return std::nullopt;
    const char c = rest_[0];
    rest_.remove_prefix(1);
    return c;
}

std::string_view NumberReader::word() {
    skip_blanks(true);
    const auto* const end = std::find_if_not(rest_.begin(), rest_.end(), is_letter);
    const std::string_view word = rest_.substr(0, std::size_t(end - rest_.begin()));
    rest_.remove_prefix(word.size());
    return word;
}

bool NumberReader::skip(char c) {
    skip_blanks(false);
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
}

Affine Affine::operator*(const Affine& in) const {
    return {a * in.a + c * in.b, b * in.a + d * in.b,     a * in.c + c * in.d,
            b * in.c + d * in.d, a * in.e + c * in.f + e, b * in.e + d * in.f + f};
}

std::optional<Affine> transform_of(std::string_view text) {
    NumberReader reader(text);
    Affine all;
    while (!reader.done()) {
        const std::string_view name = reader.word();
        if (!reader.skip('(')) return std::nullopt;
        std::vector<double> values;
        while (const auto value = reader.number()) values.push_back(*value);
        const auto one = transform_of(name, values);
        if (!one || !reader.skip(')')) return std::nullopt;
        all = all * *one;
    }
    return all;
}

std::optional<double> length_of(std::string_view text, double whole) {
    struct Unit {
        std::string_view name;
        double pixels;
    };
    const Unit units[] = {{"", 1.0},          {"px", 1.0},       {"in", 96.0},
                          {"cm", 96 / 2.54},  {"mm", 96 / 25.4}, {"pt", 96.0 / 72},
                          {"pc", 96.0 / 6.0}, {"%", whole / 100}};
    NumberReader reader(text);
    const auto value = reader.number();
    std::string_view unit = reader.rest();
    while (!unit.empty() && kBlanks.find(unit.back()) != std::string_view::npos)
        unit.remove_suffix(1);
    for (const Unit& known : units)
        if (value && unit == known.name) return *value * known.pixels;
    return std::nullopt;
}

std::optional<Affine> viewbox_of(std::string_view box, std::string_view aspect,
                                 double width, double height) {
    NumberReader reader(box);
    std::array<double, 4> v;
    for (double& value : v) {
        const auto number = reader.number();
        if (!number) return std::nullopt;
        value = *number;
    }
    if (!(v[2] > 0.0 && v[3] > 0.0)) return std::nullopt;
    double sx = width / v[2], sy = height / v[3];
    if (!aspect.starts_with("none")) {
        const bool slice = aspect.find("slice") != std::string_view::npos;
        sx = sy = slice ? std::max(sx, sy) : std::min(sx, sy);
    }
    return Affine{sx,
                  0.0,
                  0.0,
                  sy,
                  aligned(aspect, 'x', width, sx * v[2]) - sx * v[0],
                  aligned(aspect, 'Y', height, sy * v[3]) - sy * v[1]};
}

}  // namespace cydonia
