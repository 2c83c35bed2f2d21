#include "field/svg.h"

#include <cairo/cairo.h>
#include <librsvg/rsvg.h>

#include <fstream>
#include <memory>

#include "field/error.h"
#include "field/files.h"
#include "field/parallel.h"
#include "field/released.h"

namespace cydonia {
namespace {

constexpr std::size_t kLargestSvg = std::size_t{32} << 20;

constexpr std::string_view kCrispStyle =
    "* { shape-rendering: crispEdges !important; text-rendering: optimizeSpeed "
    "!important; image-rendering: optimizeSpeed !important }";

using Handle = std::unique_ptr<RsvgHandle, Released<g_object_unref>>;
using Surface = std::unique_ptr<cairo_surface_t, Released<cairo_surface_destroy>>;
using Canvas = std::unique_ptr<cairo_t, Released<cairo_destroy>>;

// Calls act(&error) and turns an error that it reports into a bad_request.
template <class Act>
auto checked(const std::string& name, const Act& act) {
    GError* error = nullptr;
    const auto result = act(&error);
    if (result) return result;
    const std::unique_ptr<GError, Released<g_error_free>> owned(error);
    std::string reason = error ? error->message : "not an SVG drawing";
    reason.erase(reason.find_last_not_of(" \n") + 1);  // libxml ends with empty lines
    throw bad_request("{}: {}", name, reason);
}

// Magnified text makes Pango print warnings about font sizes that only its layout asks
// for; the letters themselves are drawn as outlines. librsvg reports its own errors
// separately.
void silence_glib() {
    static const auto ignore = [](GLogLevelFlags, const GLogField*, gsize, gpointer) {
        return G_LOG_WRITER_HANDLED;
    };
    static const bool silent = (g_log_set_writer_func(ignore, nullptr, nullptr), true);
    static_cast<void>(silent);
}

// Loaded without a base address, so that librsvg follows no reference to another file.
Handle opened(const std::string& name, const std::string& text, SvgEdges edges) {
    const auto* bytes = reinterpret_cast<const guint8*>(text.data());
    Handle handle(checked(name, [&](GError** error) {
        return rsvg_handle_new_from_data(bytes, text.size(), error);
    }));
    if (edges == SvgEdges::kCrisp)
        checked(name, [&](GError** error) {
            return rsvg_handle_set_stylesheet(
                handle.get(), reinterpret_cast<const guint8*>(kCrispStyle.data()),
                kCrispStyle.size(), error);
        });
    return handle;
}

// The drawing's own size: its width and height, else its viewBox, else the canvas.
RsvgRectangle page_of(RsvgHandle* handle, int width, int height) {
    RsvgRectangle page{0.0, 0.0, double(width), double(height)};
    double own_width = 0.0, own_height = 0.0;
    gboolean has_width, has_height, has_box;
    RsvgLength unused_width, unused_height;
    RsvgRectangle box{};
    rsvg_handle_get_intrinsic_dimensions(handle, &has_width, &unused_width, &has_height,
                                         &unused_height, &has_box, &box);
    if (rsvg_handle_get_intrinsic_size_in_pixels(handle, &own_width, &own_height)) {
        page.width = own_width;
        page.height = own_height;
    } else if (has_box) {
        page.width = box.width;
        page.height = box.height;
    }
    return page;
}

std::uint8_t unmultiplied(std::uint32_t value, std::uint32_t alpha) {
    return static_cast<std::uint8_t>(std::min(255u, (value * 255u + alpha / 2) / alpha));
}

constexpr int kRowsAtOnce = 16;

// Cairo stores premultiplied ARGB in native words.
Field<Rgba8> pixels_of(cairo_surface_t* surface) {
    cairo_surface_flush(surface);
    Field<Rgba8> image(cairo_image_surface_get_width(surface),
                       cairo_image_surface_get_height(surface), Rgba8{});
    const unsigned char* bytes = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    parallel_for(image.height(), kRowsAtOnce, [&](int y) {
        const auto* words =
            reinterpret_cast<const std::uint32_t*>(bytes + std::ptrdiff_t(y) * stride);
        for (Rgba8& pixel : image.row(y)) {
            const std::uint32_t word = *words++;
            const std::uint32_t alpha = word >> 24;
            if (alpha > 0)
                pixel = {unmultiplied(word >> 16 & 255u, alpha),
                         unmultiplied(word >> 8 & 255u, alpha),
                         unmultiplied(word & 255u, alpha), std::uint8_t(alpha)};
        }
    });
    return image;
}

}  // namespace

bool is_svg(const Source& source) {
    std::ifstream in(source.path, std::ios::binary);
    char first = 0;
    in >> first;                                 // past spaces
    if (first == '\xef') in.ignore(2) >> first;  // past a byte order mark
    return first == '<';
}

std::array<double, 2> page_size(const Source& source) {
    silence_glib();
    const Handle handle = opened(source.path.string(),
                                 read_text(source.path, kLargestSvg), SvgEdges::kSmooth);
    const RsvgRectangle page = page_of(handle.get(), 0, 0);
    if (!(page.width > 0.0 && page.height > 0.0)) return {0.0, 0.0};
    return {page.width, page.height};
}

Field<Rgba8> read_svg(const Source& source, int width, int height, SvgEdges edges) {
    return drawn_svg(source.path.string(), read_text(source.path, kLargestSvg), width,
                     height, edges);
}

Field<Rgba8> drawn_svg(const std::string& name, const std::string& text, int width,
                       int height, SvgEdges edges) {
    silence_glib();
    const Handle handle = opened(name, text, edges);
    const RsvgRectangle page = page_of(handle.get(), width, height);
    if (!(page.width > 0.0 && page.height > 0.0))
        throw bad_request(
            "{}: the drawing has no size; give its <svg> a width and height or a viewBox",
            name);

    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
    const Canvas canvas(cairo_create(surface.get()));
    cairo_scale(canvas.get(), width / page.width, height / page.height);
    checked(name, [&](GError** error) {
        return rsvg_handle_render_document(handle.get(), canvas.get(), &page, error);
    });
    if (const cairo_status_t status = cairo_status(canvas.get()))
        throw bad_request("{}: {}", name, cairo_status_to_string(status));
    return pixels_of(surface.get());
}

}  // namespace cydonia
