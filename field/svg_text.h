#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "field/bezier.h"

namespace cydonia {

// Reads numbers as SVG writes them, with spaces and commas between.
class NumberReader {
  public:
    explicit NumberReader(std::string_view text) : rest_(text) {}

    bool done();  // nothing but spaces and commas left
    std::optional<double> number();
    std::optional<bool> flag();  // one digit, 0 or 1, that the next number may touch
    std::optional<char> letter();
    std::string_view word();  // letters, then what is left
    bool skip(char c);
    std::string_view rest() const { return rest_; }

  private:
    void skip_blanks(bool and_comma);
    std::string_view rest_;
};

// x' = a x + c y + e, y' = b x + d y + f.
struct Affine {
    double a = 1.0, b = 0.0, c = 0.0, d = 1.0, e = 0.0, f = 0.0;

    Point2 operator()(const Point2& p) const {
        return {a * p[0] + c * p[1] + e, b * p[0] + d * p[1] + f};
    }
    Affine operator*(const Affine& inner) const;  // inner first
};

// The value of a transform attribute, such as translate(3) rotate(45, 10, 10); none when
// it cannot be read.
std::optional<Affine> transform_of(std::string_view text);

// The value of a length attribute in pixels of 1/96 inch; 100% is `whole`. None when it
// cannot be read.
std::optional<double> length_of(std::string_view text, double whole);

// The transform that fits a viewBox into a page (SVG 1.1, section 7.8).
std::optional<Affine> viewbox_of(std::string_view box, std::string_view aspect,
                                 double width, double height);

}  // namespace cydonia
