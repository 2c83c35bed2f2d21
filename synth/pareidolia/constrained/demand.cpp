#include "synth/pareidolia/constrained/demand.h"

#include <algorithm>
#include <cmath>

#include "field/parallel.h"

namespace cydonia::pareidolia {
namespace {

// The farther ground in shadow is from an edge, the deeper it lies below the light, up to
// this many times its margin at the edge. A constant margin would end in a small cliff.
constexpr double kCrispCells = 2.5;
// The greatest depths, in units of the light's fall from one cell to the next: near an
// edge, so that the edge is sharp, farther from it, and anywhere. Land just below the
// light is lit by every other sun.
constexpr double kEdgeDepth = 0.4, kDepthGrowth = 0.03, kMostDepth = 1.5;

class Row {
  public:
    Row(const Demand& demand, const LightRows& rows, int row, double cells)
        : demand_(demand), rows_(rows), row_(row), cells_(cells) {}

    // The cell of the demand that contains a sample.
    std::size_t cell(int sample) const {
        const GridPoint p = rows_.position(rows_.column(sample), row_);
        const auto at = [&](double v, int size) {
            return std::clamp(static_cast<int>(std::floor((v + 0.5) * cells_)), 0,
                              size - 1);
        };
        return demand_.parts.index(at(p.x, demand_.parts.width()),
                                   at(p.y, demand_.parts.height()));
    }

    void read_parts(std::span<Part> parts) const {
        const auto [first, past] = rows_.span(row_);
        for (int i = first; i < past; ++i)
            if (rows_.counts(i)) parts[i] = demand_.parts[cell(i)];
        // The land before a shadow casts it. Where there is none, the shadow's own first
        // cell does.
        int before = first;
        for (int i = first; i < past; ++i) {
            if (!rows_.counts(i)) continue;
            const bool cast = i > first && (parts[before] == Part::kLit ||
                                            parts[before] == Part::kShadow);
            if (parts[i] == Part::kShadow && !cast) parts[before] = Part::kLit;
            before = i;
        }
        // Ground that nothing limits.
        bool lit = false;
        for (int i = past - 1; i >= first; --i) {
            lit |= parts[i] == Part::kLit;
            if (parts[i] == Part::kFree && !lit) parts[i] = Part::kAny;
        }
    }

    // `fall` is that of the light from one column to the next, in metres.
    void read_offsets(std::span<const Part> parts, double fall, std::span<float> offsets,
                      std::span<float> depths) const {
        const auto [first, past] = rows_.span(row_);
        if (first == past) return;
        const double cell_fall = fall / rows_.step();
        double margins = 0.0;  // of all lit samples so far
        double column = rows_.column(first);
        Part before = Part::kAny;
        for (int i = first; i < past; ++i) {
            if (!rows_.counts(i)) continue;
            const std::size_t at = cell(i);
            const double here = rows_.column(i), rise = fall * here;
            double margin = margins;
            if (parts[i] == Part::kLit) {
                margins += before == Part::kShadow
                               ? demand_.crisp[at] * cell_fall
                               : demand_.light[at] * fall * (here - column);
                margin = margins;
            } else if (parts[i] == Part::kShadow) {
                const double edge = demand_.edge[at] / cells_;
                margin -= demand_.crisp[at] * std::min(kCrispCells, edge) * cell_fall;
                const double within = std::max(0.0, edge - 1.0);
                depths[i] = static_cast<float>(
                    cell_fall * demand_.depth *
                    std::min(kMostDepth,
                             kEdgeDepth + kDepthGrowth * std::pow(within, 1.5)));
            }
            offsets[i] = static_cast<float>(rise - margin);
            column = here;
            before = parts[i];
        }
    }

  private:
    const Demand& demand_;
    const LightRows& rows_;
    int row_;
    double cells_;
};

}  // namespace

Records records_of(const Demand& demand, const LightRows& rows, double cells,
                   double spacing) {
    Records records{Field<Part>(rows.samples(), rows.rows()),
                    Field<float>(rows.samples(), rows.rows()),
                    Field<float>(rows.samples(), rows.rows())};
    const double fall = std::tan(demand.sun.elevation) * rows.step() * spacing;
    parallel_for(rows.rows(), 16, [&](int y) {
        const Row row(demand, rows, y, cells);
        row.read_parts(records.parts.row(y));
        row.read_offsets(records.parts.row(y), fall, records.offsets.row(y),
                         records.depths.row(y));
    });
    return records;
}

}  // namespace cydonia::pareidolia
