#include "field/strokes.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>
#include <vector>

#include "field/error.h"
#include "field/parallel.h"
#include "field/svg.h"

namespace cydonia {
namespace {

// SVG is drawn finer than the grid, up to this many pixels a side, so that strokes
// thinner than a cell are seen.
constexpr int kFinestStrokes = 2048, kFinestGrey = 4096;

int pixels_a_cell(int width, int height, int finest, int most) {
    return std::clamp(finest / std::max(width, height), 1, most);
}

constexpr Rgba8 kNothing{};
constexpr std::uint8_t kWhite = 250;  // and above: paper, JPEG's noise included

// A pixel is either drawn and opaque, or all zero.
Rgba8 snapped(Rgba8 pixel) {
    const auto [r, g, b, alpha] = pixel;
    if (alpha < 128 || (r >= kWhite && g >= kWhite && b >= kWhite)) return kNothing;
    return {r, g, b, 255};
}

constexpr int kRows = 16;  // at a time

void snap_all(Field<Rgba8>& image) {
    parallel_for(image.height(), kRows, [&](int y) {
        std::ranges::transform(image.row(y), image.row(y).begin(), snapped);
    });
}

constexpr std::size_t kManyColours = 16;

bool has_many_colours(const Field<Rgba8>& image) {
    std::vector<Rgba8> known;
    for (Rgba8 pixel : image) {
        if (pixel == kNothing || (!known.empty() && known.back() == pixel)) continue;
        if (std::find(known.begin(), known.end(), pixel) != known.end()) continue;
        if (known.size() == kManyColours) return true;
        known.push_back(pixel);
    }
    return false;
}

Rgba8 black_or_nothing(Rgba8 pixel) {
    const auto [r, g, b, alpha] = pixel;
    return alpha > 0 && std::min({r, g, b}) < 128 ? Rgba8{0, 0, 0, 255} : kNothing;
}

using Palette = std::span<const std::array<std::uint8_t, 3>>;

// The nearest colour of the palette by the greatest difference in a channel.
std::optional<Rgba8> named(Rgba8 pixel, Palette palette) {
    int least = 49;
    std::optional<Rgba8> nearest;
    for (const auto& [r, g, b] : palette) {
        const int difference = std::max(
            {std::abs(pixel[0] - r), std::abs(pixel[1] - g), std::abs(pixel[2] - b)});
        if (difference >= least) continue;
        least = difference;
        nearest = {r, g, b, 255};
    }
    return nearest;
}

bool near_a_stroke(const Field<Rgba8>& image, int x0, int y0) {
    for (int y = y0 - 2; y <= y0 + 2; ++y)
        for (int x = x0 - 2; x <= x0 + 2; ++x)
            if (image.contains(x, y) && image(x, y) != kNothing) return true;
    return false;
}

// The image with every pixel in a colour of the palette.
Field<Rgba8> painted_with(Palette palette, const Field<Rgba8>& image,
                          const Source& source) {
    Field<Rgba8> result(image.width(), image.height(), kNothing);
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (image[i] == kNothing) continue;
        if (const auto colour = named(image[i], palette))
            result[i] = *colour;
        else
            others.push_back(i);
    }
    for (const std::size_t i : others) {
        const int x = static_cast<int>(i) % image.width();
        const int y = static_cast<int>(i) / image.width();
        if (near_a_stroke(result, x, y)) continue;
        throw bad_request(
            "colour #{:02x}{:02x}{:02x} of {} has no group or type: give it one, or "
            "remove it from the drawing",
            image[i][0], image[i][1], image[i][2], source.name());
    }
    return result;
}

// The pixels [begin, end) whose centres lie in cell i. Where the image is coarser than
// the grid, it is the one pixel that holds the cell's centre.
std::pair<int, int> pixels_of_cell(int i, int cells, int pixels) {
    const auto first = [&](std::int64_t cell) {
        return static_cast<int>((2 * cell * pixels + cells - 1) / (2 * cells));
    };
    const std::pair range(first(i), first(i + 1));
    if (range.first < range.second) return range;
    const int nearest =
        static_cast<int>((2 * std::int64_t(i) + 1) * pixels / (2 * cells));
    return {nearest, nearest + 1};
}

// The colour of most of the drawn pixels; all zero when none is drawn.
class Vote {
  public:
    void clear() { counts_.clear(); }
    void add(Rgba8 colour) {
        if (colour == kNothing) return;
        for (auto& [known, count] : counts_)
            if (known == colour) return void(++count);
        counts_.emplace_back(colour, 1);
    }
    Rgba8 winner() const {
        const auto most = std::max_element(
            counts_.begin(), counts_.end(),
            [](const auto& a, const auto& b) { return a.second < b.second; });
        return most == counts_.end() ? kNothing : most->first;
    }

  private:
    std::vector<std::pair<Rgba8, int>> counts_;
};

// A cell that a stroke touches is drawn, so that thin strokes do not vanish or break.
Field<Rgba8> touched_cells(const Field<Rgba8>& image, int width, int height) {
    Field<Rgba8> cells(width, height, kNothing);
    parallel_for(height, kRows, [&](int y) {
        Vote vote;
        for (int x = 0; x < width; ++x) {
            const auto [left, right] = pixels_of_cell(x, width, image.width());
            const auto [top, bottom] = pixels_of_cell(y, height, image.height());
            vote.clear();
            for (int j = top; j < bottom; ++j)
                for (int i = left; i < right; ++i) vote.add(image(i, j));
            cells(x, y) = vote.winner();
        }
    });
    return cells;
}

Field<float> svg_grey(const Source& source, int width, int height) {
    const Field<Rgba8> drawing = read_svg(source, width, height, SvgEdges::kSmooth);
    Field<float> grey(width, height);
    parallel_for(height, kRows, [&](int y) {
        std::ranges::transform(drawing.row(y), grey.row(y).begin(), grey_over_white);
    });
    return grey;
}

}  // namespace

Field<Rgba8> read_strokes(const Source& source, int width, int height, Palette palette) {
    assert(width > 0 && height > 0);
    const int finer = pixels_a_cell(width, height, kFinestStrokes, kFinestStrokes);
    const bool is_drawing = is_svg(source);
    Field<Rgba8> image =
        is_drawing ? read_svg(source, finer * width, finer * height, SvgEdges::kCrisp)
                   : read_rgba(source);
    snap_all(image);
    if (!palette.empty())
        image = painted_with(palette, image, source);
    else if (!is_drawing && has_many_colours(image))
        std::transform(image.begin(), image.end(), image.begin(), black_or_nothing);
    Field<Rgba8> cells = touched_cells(image, width, height);
    if (std::all_of(cells.begin(), cells.end(), [](Rgba8 p) { return p == kNothing; }))
        throw bad_request(
            "{}: nothing is drawn in it (white and transparent pixels do not count)",
            source.path.string());
    return cells;
}

Field<float> read_grey_at(const Source& source, int width, int height) {
    assert(width > 0 && height > 0);
    if (!is_svg(source)) return resized(read_grey(source), width, height);
    const int finer = pixels_a_cell(width, height, kFinestGrey, 4);
    return resized(svg_grey(source, finer * width, finer * height), width, height);
}

}  // namespace cydonia
