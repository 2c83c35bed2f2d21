#include "app/reproduce/compare.h"

#include <OpenImageIO/imageio.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "app/pipeline/key.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

struct Difference {
    double sum = 0.0;  // of squares
    double most = 0.0;
    std::size_t values = 0;
    double rms() const {
        return values == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(values));
    }
};

void add(Difference& d, const std::vector<float>& a, const std::vector<float>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const bool same = a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i]));
        const double by = same ? 0.0 : std::abs(double(a[i]) - double(b[i]));
        // A number and a NaN differ infinitely.
        d.sum += std::isfinite(by) ? by * by : 1e12;
        d.most = std::max(d.most, std::isfinite(by) ? by : 1e6);
    }
    d.values += a.size();
}

// Over all parts of both images; none if they cannot be read or differ in shape.
std::optional<Difference> difference_of(const fs::path& first, const fs::path& again) {
    const auto a = OIIO::ImageInput::open(first.string());
    const auto b = OIIO::ImageInput::open(again.string());
    Difference difference;
    for (int part = 0; a && b; ++part) {
        const bool more = a->seek_subimage(part, 0);
        if (more != b->seek_subimage(part, 0)) return std::nullopt;
        if (!more) return part > 0 ? std::optional(difference) : std::nullopt;
        const OIIO::ImageSpec &s = a->spec(), &t = b->spec();
        if (s.width != t.width || s.height != t.height || s.nchannels != t.nchannels ||
            s.channelnames != t.channelnames)
            return std::nullopt;
        std::vector<float> u(static_cast<std::size_t>(s.image_pixels()) *
                             static_cast<std::size_t>(s.nchannels));
        std::vector<float> v(u.size());
        if (!a->read_image(part, 0, 0, s.nchannels, OIIO::TypeFloat, u.data()) ||
            !b->read_image(part, 0, 0, s.nchannels, OIIO::TypeFloat, v.data()))
            return std::nullopt;
        add(difference, u, v);
    }
    return std::nullopt;
}

bool is_one_of(const fs::path& file, std::initializer_list<const char*> extensions) {
    return std::ranges::find(extensions, file.extension().string()) != extensions.end();
}

// Heights in any format, and files for other programs.
bool is_by_bytes(const fs::path& file) {
    return *file.begin() == "export" || file.stem() == "terrain" ||
           !is_one_of(file, {".png", ".exr", ".jpg"});
}

}  // namespace

Comparison compare(const ManifestFile::Output& output, const fs::path& first,
                   const fs::path& again, bool jittered) {
    std::error_code none;
    if (!fs::is_regular_file(again, none)) return {Likeness::kMissing, ""};
    const std::string now = hex(hash_of_file(again));
    if (now == output.xxh3) return {Likeness::kEqual, ""};
    if (is_one_of(output.file, {".html"})) return {Likeness::kNotCompared, "timings"};
    if (is_one_of(output.file, {".mp4", ".gif", ".webp"}))
        return {Likeness::kNotCompared, "a video; its frames are"};
    if (is_by_bytes(output.file)) return {Likeness::kDifferent, "other bytes"};
    if (!fs::is_regular_file(first, none) || hex(hash_of_file(first)) != output.xxh3)
        return {Likeness::kDifferent,
                "other bytes; the first file is not there to compare pixels with"};

    const auto difference = difference_of(first, again);
    if (!difference) return {Likeness::kDifferent, "not one shape"};
    if (difference->most == 0.0) return {Likeness::kSamePixels, ""};
    const std::string by =
        fmt::format("rms {:.4f}, at most {:.3g}", difference->rms(), difference->most);
    const bool alike = jittered && difference->rms() <= kAlikeRms;
    return {alike ? Likeness::kAlike : Likeness::kDifferent, by};
}

bool is_failure(Likeness likeness) {
    return likeness == Likeness::kDifferent || likeness == Likeness::kMissing;
}

std::string text_of(const Comparison& comparison) {
    constexpr const char* kTexts[] = {"equal",        "equal pixels", "alike",
                                      "not compared", "DIFFERENT",    "MISSING"};
    const std::string text = kTexts[static_cast<int>(comparison.likeness)];
    return comparison.detail.empty() ? text
                                     : fmt::format("{} ({})", text, comparison.detail);
}

}  // namespace cydonia
