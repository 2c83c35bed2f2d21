#include "synth/pareidolia/target.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "field/error.h"
#include "field/image.h"
#include "synth/pareidolia/placed.h"

namespace cydonia::pareidolia {
namespace {

Field<std::uint8_t> dark_of(const Field<float>& lightness) {
    Field<std::uint8_t> dark(lightness.width(), lightness.height());
    std::transform(lightness.begin(), lightness.end(), dark.begin(),
                   [](float l) { return static_cast<std::uint8_t>(l < 0.5f); });
    return dark;
}

double total(const Field<float>& values) {
    double sum = 0.0;
    for (const float value : values) sum += value;
    return sum;
}

// What becomes of the picture's shadow on the land, in cells.
struct Ink {
    double drawn = 0.0;     // as if the land had no end and cells no size
    double on_land = 0.0;   // of it
    double vanished = 0.0;  // of that, farther than a cell from any cell in shadow
};

bool any_around(const Field<std::uint8_t>& target, int x, int y) {
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, target.height() - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, target.width() - 1); ++i)
            if (target(i, j)) return true;
    return false;
}

Ink ink_of(const Picture& picture, const Frame& frame,
           const Field<std::uint8_t>& target) {
    Size size = finest(picture, frame);
    if (picture.has_pixels && std::max(picture.width, picture.height) <= 4096.0)
        size = {static_cast<int>(picture.width), static_cast<int>(picture.height)};
    Field<float> fine = picture.lightness(size.width, size.height);
    for (float& l : fine) l = l < 0.5f ? 0.0f : 1.0f;
    Ink ink;
    const double light = total(fine);
    ink.drawn =
        (double(fine.size()) - light) / double(fine.size()) * frame.width * frame.height;

    Picture two_tone{picture.name, double(size.width), double(size.height), true, {}};
    two_tone.lightness = [&](int width, int height) {
        return resized(fine, width, height);
    };
    const Field<float> cells = placed(two_tone, frame, target.width(), target.height());
    for (int y = 0; y < target.height(); ++y)
        for (int x = 0; x < target.width(); ++x) {
            const double share = 1.0 - double(cells(x, y));
            if (share <= 0.0) continue;
            ink.on_land += share;
            if (!any_around(target, x, y)) ink.vanished += share;
        }
    return ink;
}

// Why a picture may have no shadow, or nothing but shadow.
std::string reading_hint(const ImageOptions& options, bool all_shadow) {
    if (!options.target) return "";
    if (options.reading == Reading::kAlpha && all_shadow)
        return "; it is opaque all over: read it by reading = \"dark\"";
    if (options.reading == Reading::kDark && !all_shadow)
        return "; where a logo is white on nothing, read it by reading = \"alpha\"";
    return "";
}

void refuse_empty(const ImageOptions& options, const Picture& picture, const Ink& ink,
                  int width) {
    if (ink.drawn <= 0.0)
        throw bad_request(
            "{}: no shadow in the target: draw what should be dark in black on white, "
            "or change threshold or invert{}",
            picture.name, reading_hint(options, false));
    if (ink.on_land < 0.01 * ink.drawn)
        throw bad_request(
            "{}: no shadow on the land: its position and scale put it "
            "beyond the extent",
            picture.name);
    throw bad_request(
        "{}: no shadow is left of the target: all of it is thinner than a cell (1/{} of "
        "the land's width): draw it thicker, enlarge it by scale, or raise "
        "terrain.samples",
        picture.name, width);
}

void refuse_all_dark(const ImageOptions& options, const Picture& picture) {
    throw bad_request(
        "{}: the target is all shadow: leave light ground around the image for its "
        "casters, by the drawing itself or a smaller scale{}",
        picture.name, reading_hint(options, true));
}

std::string percent(double share) {
    return share < 0.1 ? fmt::format("{:.1f}%", 100.0 * share)
                       : fmt::format("{:.0f}%", 100.0 * share);
}

void say_size(const Picture& picture, const Frame& frame, Progress& progress) {
    if (!picture.has_pixels) return;
    if (std::abs(frame.width - picture.width) < 0.5 &&
        std::abs(frame.height - picture.height) < 0.5)
        return;
    progress.note(fmt::format("{}: {:.0f}x{:.0f} pixels on {:.0f}x{:.0f} cells",
                              picture.name, picture.width, picture.height, frame.width,
                              frame.height));
}

void say_losses(const Picture& picture, const Ink& ink, Progress& progress) {
    const double beyond = 1.0 - ink.on_land / ink.drawn;
    if (beyond > 0.01)
        progress.warn(fmt::format(
            "{}: {} of its shadow lies beyond the land: change position or scale",
            picture.name, percent(beyond)));
    const double thin = ink.vanished / ink.on_land;
    if (thin > 0.005)
        progress.warn(fmt::format(
            "{}: {} of its shadow is thinner than a cell and vanishes: draw it thicker, "
            "enlarge it, or raise terrain.samples",
            picture.name, percent(thin)));
}

void say_small(const Picture& picture, std::ptrdiff_t cells, Progress& progress) {
    constexpr std::ptrdiff_t kSeen = 64;
    if (cells < kSeen)
        progress.warn(fmt::format(
            "{}: its shadow is {} {} in all, too little to be made out: enlarge it by "
            "scale, or raise terrain.samples",
            picture.name, cells, cells == 1 ? "cell" : "cells"));
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return text;
}

}  // namespace

Field<std::uint8_t> shadow_target(const ImageOptions& image, int width, int height,
                                  Progress& progress) {
    return shadow_target(image, picture_of(image, progress), width, height, progress);
}

Field<std::uint8_t> shadow_target(const ImageOptions& image, const Picture& picture,
                                  int width, int height, Progress& progress) {
    const Frame frame = frame_of(picture, image.placing, width, height);
    const Field<std::uint8_t> target = dark_of(placed(picture, frame, width, height));
    const auto dark = std::count(target.begin(), target.end(), 1);
    if (dark == static_cast<std::ptrdiff_t>(target.size()))
        refuse_all_dark(image, picture);
    const Ink ink = ink_of(picture, frame, target);
    if (dark == 0) refuse_empty(image, picture, ink, width);
    say_size(picture, frame, progress);
    say_losses(picture, ink, progress);
    say_small(picture, dark, progress);
    return target;
}

Field<std::uint8_t> silent_target(const ImageOptions& image, const Picture& picture,
                                  int width, int height) {
    return dark_of(
        placed(picture, frame_of(picture, image.placing, width, height), width, height));
}

std::string image_name(const ImageOptions& image) {
    constexpr std::size_t kLongest = 48;
    std::string name = image.target ? image.target->path.stem().string() : image.text;
    std::replace_if(
        name.begin(), name.end(),
        [](unsigned char c) { return !std::isalnum(c) && c != '-' && c != '_'; }, '_');
    name.resize(std::min(name.size(), kLongest));
    const bool has_letters = std::any_of(name.begin(), name.end(),
                                         [](unsigned char c) { return std::isalnum(c); });
    return has_letters ? name : image.target ? "image" : "text";
}

std::vector<std::string> image_names(const std::vector<ImageOptions>& images) {
    std::vector<std::string> names;
    std::set<std::string> taken;  // in lower case: some file systems know no other
    for (const ImageOptions& image : images) {
        const std::string own = image_name(image);
        std::string name = own;
        for (int i = 2; !taken.insert(lower(name)).second; ++i)
            name = fmt::format("{}-{}", own, i);
        names.push_back(name);
    }
    return names;
}

}  // namespace cydonia::pareidolia
