#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <type_traits>

#include "field/error.h"
#include "field/flaw.h"
#include "field/gdal.h"
#include "field/image.h"

namespace cydonia {
namespace {

constexpr int kMostChannels = 256;

struct Format {
    const char* name;  // OpenImageIO's
    std::string_view magic;
};
constexpr Format kFormats[] = {
    {"png", "\x89PNG"},
    {"jpeg", "\xff\xd8\xff"},
    {"openexr", "\x76\x2f\x31\x01"},
    {"tiff", "II*"},
    {"tiff", std::string_view("MM\0*", 4)},
    {"pnm", "P2"},
    {"pnm", "P3"},
    {"pnm", "P5"},
    {"pnm", "P6"},
};

// Finds the format by the file's content, whatever its name says. Untrusted files reach
// no other decoder than these.
const char* format_of(const std::filesystem::path& path) {
    char bytes[4] = {};
    std::ifstream in(path, std::ios::binary);
    in.read(bytes, sizeof bytes);
    const std::string_view head(bytes, static_cast<std::size_t>(in.gcount()));
    for (const Format& format : kFormats)
        if (head.starts_with(format.magic)) return format.name;
    throw bad_request("{}: not a PNG, JPEG, TIFF, OpenEXR or PNM image", path.string());
}

// A library's message, on one line.
std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text.empty() ? "no reason given" : text;
}

// An image that was opened and checked. Nothing of its size is allocated yet.
class Reader {
  public:
    explicit Reader(const std::filesystem::path& path) : path_(path) {
        const char* format = format_of(path);
        if (const std::string_view flaw = flaw_of(path, format); !flaw.empty())
            throw bad_request("{}: {}", path.string(), flaw);
        input_ = OIIO::ImageInput::create(format);
        OIIO::ImageSpec wishes;
        wishes["oiio:UnassociatedAlpha"] = 1;  // colours as they are stored
        if (!input_)
            throw bad_request("{}: {}", path.string(), one_line(OIIO::geterror()));
        if (!input_->open(path.string(), spec_, wishes))
            throw bad_request("{}: {}", path.string(), one_line(input_->geterror()));
        expect_sane();
    }

    const OIIO::ImageSpec& spec() const { return spec_; }

    // Calls use(y, values) for every row from north to south. The first `channels`
    // channels are interleaved in `values`.
    template <class T, class Use>
    void rows(int channels, const Use& use) {
        // The rows are read one by one: a cut TIFF reports no error when several are read
        // at once.
        const int step = spec_.tile_width ? spec_.tile_height : 1;
        const std::size_t row_size = std::size_t(spec_.width) * std::size_t(channels);
        std::vector<T> block(row_size * std::size_t(std::min(step, spec_.height)));
        for (int y = 0; y < spec_.height; y += step) {
            const int end = std::min(y + step, spec_.height);
            if (!read(y, end, channels, block.data())) throw broken_at(y);
            for (int row = y; row < end; ++row)
                use(row, block.data() + row_size * std::size_t(row - y));
        }
    }

  private:
    void expect_sane() const {
        if (spec_.width < 1 || spec_.height < 1 || spec_.nchannels < 1)
            throw bad_request("{}: has no pixels", path_.string());
        if (spec_.width > kLargestSide || spec_.height > kLargestSide)
            throw bad_request("{}: {} x {} pixels, more than {} x {}", path_.string(),
                              spec_.width, spec_.height, kLargestSide, kLargestSide);
        if (spec_.nchannels > kMostChannels || spec_.tile_width > kLargestSide ||
            spec_.tile_height > kLargestSide || spec_.tile_height < 0)
            throw bad_request("{}: {} channels in tiles of {} x {}, too large",
                              path_.string(), spec_.nchannels, spec_.tile_width,
                              spec_.tile_height);
        if (spec_.deep || spec_.depth > 1)
            throw bad_request("{}: a deep or 3D image, not a flat one", path_.string());
    }

    template <class T>
    bool read(int begin, int end, int channels, T* values) {
        const auto type = OIIO::BaseTypeFromC<T>::value;
        const int top = spec_.y;
        if (spec_.tile_width == 0)
            return input_->read_scanlines(0, 0, top + begin, top + end, spec_.z, 0,
                                          channels, type, values);
        return input_->read_tiles(0, 0, spec_.x, spec_.x + spec_.width, top + begin,
                                  top + end, spec_.z, spec_.z + 1, 0, channels, type,
                                  values);
    }

    Error broken_at(int y) {
        return bad_request("{}: truncated or damaged after row {} of {} ({})",
                           path_.string(), y, spec_.height, one_line(input_->geterror()));
    }

    const QuietGdal
        quiet_;  // GDAL also receives the messages of libtiff that OpenImageIO causes
    std::filesystem::path path_;
    std::unique_ptr<OIIO::ImageInput> input_;
    OIIO::ImageSpec spec_;
};

// The indices of red, green, blue and alpha among the first channels; alpha is -1 in an
// opaque image.
struct Layout {
    int channels, green, blue, alpha;
};

Layout layout_of(const OIIO::ImageSpec& spec) {
    const bool colour = spec.nchannels >= 3;
    const int colours = colour ? 3 : 1;
    const int alpha = spec.alpha_channel == colours ? colours : -1;
    return {colours + (alpha < 0 ? 0 : 1), colour ? 1 : 0, colour ? 2 : 0, alpha};
}

float clamped(float value) { return value > 0.0f ? std::min(value, 1.0f) : 0.0f; }

// Stored values weighted as Rec. 709 weights light, and limited to 0 to 1 whatever the
// file holds.
float grey_of(const float* values, const Layout& at) {
    const float luma = at.green == 0 ? values[0]
                                     : 0.2126f * values[0] + 0.7152f * values[at.green] +
                                           0.0722f * values[at.blue];
    if (at.alpha < 0) return clamped(luma);
    return 1.0f - clamped(values[at.alpha]) * (1.0f - clamped(luma));
}

}  // namespace

std::uint64_t pixels_of(const Source& source) {
    try {
        const Reader reader(source.path);
        return std::uint64_t(reader.spec().width) * std::uint64_t(reader.spec().height);
    } catch (const Error&) {  // read_rgba() and the others will give the reason
        return 0;
    }
}

Field<Rgba8> read_rgba(const Source& source) {
    Reader reader(source.path);
    const Layout at = layout_of(reader.spec());
    Field<Rgba8> image(reader.spec().width, reader.spec().height);
    reader.rows<std::uint8_t>(at.channels, [&](int y, const std::uint8_t* values) {
        for (Rgba8& pixel : image.row(y)) {
            const std::uint8_t alpha = at.alpha < 0 ? 255 : values[at.alpha];
            pixel = {values[0], values[at.green], values[at.blue], alpha};
            values += at.channels;
        }
    });
    return image;
}

Field<float> read_grey(const Source& source) {
    Reader reader(source.path);
    const Layout at = layout_of(reader.spec());
    Field<float> image(reader.spec().width, reader.spec().height);
    reader.rows<float>(at.channels, [&](int y, const float* values) {
        for (float& pixel : image.row(y)) {
            pixel = grey_of(values, at);
            values += at.channels;
        }
    });
    return image;
}

Field<Rgb> read_exr_rgb(const std::filesystem::path& path) {
    Reader reader(path);
    if (reader.spec().nchannels < 3)
        throw bad_request("{}: {} channels, not red, green and blue", path.string(),
                          reader.spec().nchannels);
    Field<Rgb> image(reader.spec().width, reader.spec().height);
    reader.rows<float>(3, [&](int y, const float* values) {
        for (Rgb& pixel : image.row(y)) {
            pixel = {values[0], values[1], values[2]};
            values += 3;
        }
    });
    return image;
}

Field<float> read_exr(const std::filesystem::path& path, Metadata* metadata) {
    Reader reader(path);
    if (reader.spec().nchannels != 1)
        throw bad_request("{}: {} channels, not a single one", path.string(),
                          reader.spec().nchannels);
    Field<float> image(reader.spec().width, reader.spec().height);
    reader.rows<float>(1, [&](int y, const float* values) {
        std::copy_n(values, image.width(), image.row(y).begin());
    });
    if (metadata)
        for (const OIIO::ParamValue& attribute : reader.spec().extra_attribs)
            if (attribute.type() == OIIO::TypeString)
                (*metadata)[attribute.name().string()] = attribute.get_string();
    return image;
}

}  // namespace cydonia
