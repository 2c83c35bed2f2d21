// The page holds everything as text: pictures and heights are base64 in attributes that
// the scripts read. No text of a scene ever becomes part of a script.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "field/base64.h"
#include "field/data.h"
#include "field/files.h"
#include "render/report/report.h"
#include "render/report/template.h"

namespace cydonia::render {
namespace {

std::string data_text(const char* name) {
    return read_text(data_file(fmt::format("report/{}", name)));
}

// Escapes what would end the script element from inside a string or a comment.
std::string for_script_element(std::string script) {
    for (const auto& [mark, harmless] :
         {std::pair<std::string, std::string>{"</script", "<\\/script"},
          {"<!--", "<\\!--"}}) {
        for (auto at = script.find(mark); at != script.npos;
             at = script.find(mark, at + harmless.size()))
            script.replace(at, mark.size(), harmless);
    }
    return script;
}

// A path, escaped for a link.
std::string link_to(std::string_view file) {
    std::string link;
    for (const char c : file) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9') ||
                           std::string_view("-_./").find(c) != std::string_view::npos;
        link += plain ? std::string(1, c)
                      : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return link;
}

std::string seconds_text(double seconds) {
    if (seconds < 0.05) return fmt::format("{:.0f} ms", 1000.0 * seconds);
    if (seconds < 99.5) return fmt::format("{:.1f} s", seconds);
    return fmt::format("{:.0f} min", seconds / 60.0);
}

std::string angle_text(double radians_) {
    return fmt::format("{:.4g}", std::round(degrees(radians_) * 1e6) / 1e6);
}

// Heights in 65535ths of the relief, 16 bits a sample, low byte first.
std::string levels_of(const Field<float>& heights, float low, float high) {
    std::string bytes;
    bytes.reserve(2 * heights.size());
    const float scale = high > low ? 65535.0f / (high - low) : 0.0f;
    for (const float height : heights) {
        const long level = std::clamp(std::lround((height - low) * scale), 0L, 65535L);
        bytes += static_cast<char>(level & 255);
        bytes += static_cast<char>(level >> 8);
    }
    return bytes;
}

// A mask with eight samples a byte, the first in the lowest bit.
std::string bits_of(const Field<std::uint8_t>& field) {
    std::string bytes((field.size() + 7) / 8, '\0');
    for (std::size_t i = 0; i < field.size(); ++i)
        if (field[i]) bytes[i / 8] = static_cast<char>(bytes[i / 8] | 1 << i % 8);
    return bytes;
}

Values values_of(const ReportTable& table);
Values values_of(const ReportImage& image);
Values values_of(const ReportVideo& video);
Values values_of(const ReportRow& row);
Values values_of(const ReportPicture& picture);

template <class T>
std::vector<Values> values_of(const std::vector<T>& all) {
    std::vector<Values> values;
    for (const T& one : all) values.push_back(values_of(one));
    return values;
}

Values values_of(const ReportPicture& picture) {
    return {{{"label", picture.label},
             {"file", link_to(picture.file)},
             {"width", std::to_string(picture.width)},
             {"height", std::to_string(picture.height)},
             {"ratio", fmt::format("{:.4f}", double(picture.width) / picture.height)},
             {"data", "data:image/jpeg;base64," + base64(picture.jpeg)}}};
}

Values values_of(const ReportVideo& video) {
    Values values = {{{"label", video.label}, {"file", link_to(video.file)}}};
    values.texts["source"] = video.mp4.empty()
                                 ? link_to(video.file)
                                 : "data:video/mp4;base64," + base64(video.mp4);
    if (video.poster) values.lists["poster"] = {values_of(*video.poster)};
    return values;
}

Values values_of(const ReportRow& row) {
    return {{{"name", row.name}, {"value", row.value}}};
}

Values values_of(const ReportTable& table) {
    return {{{"title", table.title}}, {{"rows", values_of(table.rows)}}};
}

Values values_of(const ReportImage& image) {
    Values values = {{{"name", image.name},
                      {"verdict", image.verdict},
                      {"failed", image.passed ? "" : "failed"},
                      {"azimuth", angle_text(image.sun.azimuth)},
                      {"elevation", angle_text(image.sun.elevation)},
                      {"target", base64(bits_of(image.target))},
                      {"window", base64(bits_of(image.window))}},
                     {{"pictures", values_of(image.pictures)}}};
    return values;
}

// Rows with their share of the longest, for a bar.
std::vector<Values> values_of(const std::vector<ReportStep>& steps, double longest) {
    std::vector<Values> values;
    for (const ReportStep& step : steps) {
        const double share = longest > 0.0 ? 100.0 * step.seconds / longest : 0.0;
        values.push_back({{{"name", step.name},
                           {"time", seconds_text(step.seconds)},
                           {"share", fmt::format("{:.1f}", share)},
                           {"options", step.options}}});
    }
    return values;
}

double longest_of(const Report& report) {
    double longest = 0.0;
    for (const auto* steps : {&report.stages, &report.other_steps})
        for (const ReportStep& step : *steps) longest = std::max(longest, step.seconds);
    return longest;
}

Values land_of(const Report& report) {
    const auto [low, high] = std::ranges::minmax_element(report.heights);
    return {{{"columns", std::to_string(report.heights.width())},
             {"lines", std::to_string(report.heights.height())},
             {"spacing", fmt::format("{}", report.spacing)},
             {"low", fmt::format("{}", *low)},
             {"high", fmt::format("{}", *high)},
             {"heights", base64(levels_of(report.heights, *low, *high))},
             {"water", base64(bits_of(report.water))},
             {"azimuth", angle_text(report.sun.azimuth)},
             {"elevation", angle_text(report.sun.elevation)}},
            {{"images", values_of(report.images)}}};
}

}  // namespace

std::string report_page(const Report& report) {
    Values values = {{{"title", report.title},
                      {"scene", report.scene},
                      {"version", report.version},
                      {"style", data_text("page.css")},
                      {"theme", for_script_element(data_text("theme.js"))}}};
    auto& lists = values.lists;
    lists["facts"] = values_of(report.facts);
    lists["frames"] = values_of(report.frames);
    lists["videos"] = values_of(report.videos);
    lists["images"] = values_of(report.images);
    lists["relief"] = values_of(report.relief);
    const double longest = longest_of(report);
    lists["stages"] = values_of(report.stages, longest);
    lists["steps"] = values_of(report.other_steps, longest);
    lists["figures"] = values_of(report.figures);
    for (const char* part : {"frames", "figures", "relief", "images"})
        if (!lists[part].empty()) values.texts[std::string("has_") + part] = "yes";
    if (!report.heights.empty()) {
        lists["land"] = {land_of(report)};
        values.texts["three"] = for_script_element(report.three);
        for (const char* script : {"light", "view", "page"})
            values.texts[std::string(script) + "_js"] =
                for_script_element(data_text(fmt::format("{}.js", script).c_str()));
    }
    return filled(data_text("page.html"), values);
}

}  // namespace cydonia::render
