#include "app/library_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/library_colours.h"
#include "field/markup.h"

namespace cydonia {
namespace {

using statistics::Analysis;
using statistics::Statistics;

constexpr double kWidth = 860.0, kLeft = 190.0, kRight = 30.0;  // pixels
constexpr double kRow = 22.0, kHead = 34.0, kFoot = 26.0, kTop = 44.0;
constexpr int kPanels = (statistics::kQuantities + 1) / 2;  // in each of two columns
constexpr std::array<const char*, statistics::kQuantities> kUnits = {
    "m",
    "degrees",
    "asinh of 100 times the change of slope a sample",
    "m in a window",
    "0 to 1",
    "octaves a band",
    "m",
    "m",
    "response",
    "% of samples",
    "m",
    "m",
    "response",
    "% of samples",
    "m",
    "m",
    "response",
    "% of samples",
    "m",
    "response",
    "% of samples"};

struct Row {
    std::string name;
    std::string colour;
    std::vector<Statistics> examples;
};

// 1, 2 or 5 times a power of ten, so that there are about so many in a span.
double nice_step(double span, int about) {
    const double rough = span / about,
                 power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double times : {1.0, 2.0, 5.0})
        if (rough <= times * power) return times * power;
    return 10.0 * power;
}

std::string panel(const std::vector<Row>& rows, int quantity, double top) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Row& row : rows)
        for (const Statistics& s : row.examples)
            if (s.count > 0) {
                low = std::min(low, s.mean - s.deviation);
                high = std::max(high, s.mean + s.deviation);
            }
    const auto q = std::size_t(quantity);
    std::string text = fmt::format("<text x='12' y='{}' class='head'>{}, {}</text>\n",
                                   top + 20.0, statistics::kQuantityNames[q], kUnits[q]);
    if (!(high > low)) return text;
    const auto x = [&](double value) {
        return kLeft + (value - low) / (high - low) * (kWidth - kLeft - kRight);
    };
    const double bottom = top + kHead + kRow * double(rows.size());
    const double step = nice_step(high - low, 6);
    for (double tick = std::ceil(low / step) * step; tick <= high; tick += step)
        text += fmt::format(
            "<line x1='{0:.1f}' x2='{0:.1f}' y1='{1}' y2='{2}' class='tick'/>"
            "<text x='{0:.1f}' y='{3}' class='number'>{4:g}</text>\n",
            x(tick), top + kHead - 6.0, bottom, bottom + 15.0,
            std::abs(tick) < 1e-9 * step ? 0.0 : tick);
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const Row& row = rows[r];
        const double y = top + kHead + kRow * (double(r) + 0.5);
        text += fmt::format("<text x='{}' y='{:.1f}' class='name'>{}</text>\n",
                            kLeft - 14.0, y + 4.0, escaped(row.name));
        for (std::size_t e = 0; e < row.examples.size(); ++e) {
            const Statistics& s = row.examples[e];
            if (s.count == 0) continue;
            // One above the other, all within the row.
            const double at =
                y +
                (row.examples.size() < 2
                     ? 0.0
                     : (double(e) / double(row.examples.size() - 1) - 0.5) * 0.6 * kRow);
            text += fmt::format(
                "<line x1='{:.1f}' x2='{:.1f}' y1='{:.1f}' y2='{:.1f}' stroke='{}' "
                "stroke-width='1.5' stroke-opacity='0.45'/>"
                "<circle cx='{:.1f}' cy='{:.1f}' r='3' fill='{}'/>\n",
                x(s.mean - s.deviation), x(s.mean + s.deviation), at, at, row.colour,
                x(s.mean), at, row.colour);
        }
    }
    return text;
}

}  // namespace

std::string library_plot(const statistics::Library& library, double level,
                         const std::string& land_name, const Analysis* land) {
    std::string panels;
    double top = kTop, high = 0.0;
    for (int q = 0; q < statistics::kQuantities; ++q) {
        if (q % kPanels == 0) {
            top = kTop;
            panels += fmt::format("{}<g transform='translate({},0)'>\n", q ? "</g>" : "",
                                  q / kPanels * kWidth);
        }
        std::vector<Row> rows;
        for (std::size_t t = 0; t < library.types().size(); ++t) {
            Row& row = rows.emplace_back(
                Row{library.types()[t].name, hex_of(library.types()[t].colour), {}});
            for (const Analysis& example : library.types()[t].examples)
                row.examples.push_back(example[std::size_t(q)]);
        }
        if (land) rows.push_back({land_name, "#000000", {(*land)[std::size_t(q)]}});
        panels += panel(rows, q, top);
        high = kHead + kRow * double(rows.size()) + kFoot;
        top += high;
    }
    return fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" viewBox="0 0 {0} {1}">
<style>text {{ font: 12px "DejaVu Sans", sans-serif; fill: #222 }} .head {{ font-weight: bold }}
.name {{ text-anchor: end }} .number {{ text-anchor: middle; fill: #666 }}
.tick {{ stroke: #ddd }}</style>
<rect width="{0}" height="{1}" fill="white"/>
<text x="12" y="24" class="head">{2:g} m from sample to sample: mean and standard deviation of each example</text>
{3}</g></svg>
)",
        2.0 * kWidth, kTop + kPanels * high + 6.0, level, panels);
}

}  // namespace cydonia
