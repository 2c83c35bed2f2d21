#include "app/gallery/contact_sheet.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/gallery/page.h"
#include "field/svg.h"

namespace cydonia {
namespace {

// Pixels.
constexpr int kColumns = 6;
constexpr int kTileWidth = 240, kTileHeight = 180;
constexpr int kCaption = 26;  // height of the line
constexpr int kGap = 12;
constexpr double kLetter = 15.0;
constexpr double kLetterShape = 0.66;  // width of a letter as a share of its size

constexpr Rgb8 kGround{34, 34, 34};
constexpr const char* kInk = "#e4e4e4";

struct Corner {
    int x, y;
};

void lay(const Field<Rgb8>& picture, Corner corner, Field<Rgb8>& sheet) {
    for (int y = 0; y < picture.height(); ++y) {
        std::ranges::copy(picture.row(y),
                          sheet.row(corner.y + y).begin() + std::ptrdiff_t{corner.x});
    }
}

// Where the pictures of each row end and the captions begin. A row is as high as its
// highest picture.
std::vector<int> floors_of(const std::vector<Field<Rgb8>>& pictures, int columns) {
    std::vector<int> floors;
    int top = kGap, highest = 0;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        highest = std::max(highest, pictures[i].height());
        if ((i + 1) % columns != 0 && i + 1 != pictures.size()) continue;
        floors.push_back(top + highest);
        top += highest + kCaption + kGap;
        highest = 0;
    }
    return floors;
}

// `middle` and `top` give the place of the caption's line.
std::string caption_of(const std::string& text, int middle, int top) {
    const double letters = static_cast<double>(std::max<std::size_t>(text.size(), 1));
    return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{:.2f}\">{}</text>\n", middle,
                       top + kCaption - 8,
                       std::min(kLetter, kTileWidth / (kLetterShape * letters)),
                       escaped(text));
}

void draw_over(const Field<Rgba8>& drawing, Field<Rgb8>& sheet) {
    for (std::size_t i = 0; i < sheet.size(); ++i) {
        const int alpha = drawing[i][3];
        for (int c = 0; c < 3; ++c) {
            sheet[i][c] = static_cast<std::uint8_t>(
                (drawing[i][c] * alpha + sheet[i][c] * (255 - alpha) + 127) / 255);
        }
    }
}

Field<Rgb8> scaled(const Field<Rgb8>& picture, int width, int height) {
    Field<Rgb8> result(width, height);
    Field<float> channel(picture.width(), picture.height());
    for (int c = 0; c < 3; ++c) {
        std::ranges::transform(picture, channel.begin(),
                               [c](const Rgb8& rgb) { return float{1} * rgb[c]; });
        const Field<float> small = resized(channel, width, height);
        for (std::size_t i = 0; i < small.size(); ++i) {
            result[i][c] =
                static_cast<std::uint8_t>(std::clamp(std::lround(small[i]), 0l, 255l));
        }
    }
    return result;
}

}  // namespace

Field<Rgb8> contact_sheet(const std::vector<Tile>& tiles) {
    const int columns = std::clamp(static_cast<int>(tiles.size()), 1, kColumns);
    std::vector<Field<Rgb8>> pictures;
    for (const Tile& tile : tiles) {
        pictures.push_back(fitted(tile.picture, kTileWidth, kTileHeight));
    }
    const std::vector<int> floors = floors_of(pictures, columns);
    Field<Rgb8> sheet(kGap + columns * (kTileWidth + kGap),
                      (floors.empty() ? 0 : floors.back() + kCaption) + kGap, kGround);

    std::string captions;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const int middle =
            kGap + kTileWidth / 2 + static_cast<int>(i) % columns * (kTileWidth + kGap);
        const int floor = floors[i / columns];
        lay(pictures[i], {middle - pictures[i].width() / 2, floor - pictures[i].height()},
            sheet);
        captions += caption_of(tiles[i].caption, middle, floor);
    }
    const std::string drawing = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" "
        "font-family=\"sans-serif\" text-anchor=\"middle\" fill=\"{}\">\n{}</svg>\n",
        sheet.width(), sheet.height(), kInk, captions);
    draw_over(drawn_svg("the captions", drawing, sheet.width(), sheet.height(),
                        SvgEdges::kSmooth),
              sheet);
    return sheet;
}

Field<Rgb8> fitted(const Field<Rgb8>& picture, int width, int height) {
    const double scale =
        std::min(1.0 * width / picture.width(), 1.0 * height / picture.height());
    if (scale >= 1.0) return picture;
    const auto side = [scale](int pixels) {
        return std::max(1, static_cast<int>(std::lround(scale * pixels)));
    };
    return scaled(picture, side(picture.width()), side(picture.height()));
}

std::string jpeg_within(const Field<Rgb8>& picture, std::size_t most_bytes) {
    for (int quality = 95; quality >= 50; quality -= 5) {
        std::string bytes = jpeg_of(picture, quality);
        if (bytes.size() <= most_bytes || picture.size() <= 1) return bytes;
    }
    return jpeg_within(fitted(picture, std::max(1, picture.width() / 4 * 3),
                              std::max(1, picture.height() / 4 * 3)),
                       most_bytes);
}

}  // namespace cydonia
