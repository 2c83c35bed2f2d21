#include "synth/genetic/evolution/fitness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "field/parallel.h"

namespace cydonia::genetic {
namespace {

constexpr double kQuarter = 0.25;  // docs/papers.md, Saunders 2006, 2
constexpr double kHalf = 0.5;
constexpr double kLevel = 0.05;  // share of a type's slopes: flatter land faces nowhere
constexpr std::array<statistics::Quantity, 3> kJudged = {
    statistics::Quantity::kElevation, statistics::Quantity::kSlope,
    statistics::Quantity::kCurvature};

double gaussian(double difference, double deviation) {
    return std::exp(-0.5 * difference * difference /
                    (deviation * deviation + 1e-12));  // eq. IV.5
}

// Where the thirds of a chunk begin. They are symmetric, for mirrored chunks.
std::array<int, 4> thirds(int side) {
    const int first = std::max(1, int(std::lround(side / 3.0)));
    return {0, first, std::max(first + 1, side - first), side};
}

ChunkShape shape_in(const SampleLand& land, const Gene& gene, int side, double gain) {
    const auto edges = thirds(side);
    ChunkShape shape;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            int a = column, b = row;
            if (gene.turn & 1) std::swap(a, b);
            if (gene.turn & 2) a = 2 - a;
            if (gene.turn & 4) b = 2 - b;
            const auto i = std::size_t(a), j = std::size_t(b);
            shape.parts[std::size_t(3 * row + column)] =
                gain * land.mean(gene.x + edges[i], gene.y + edges[j],
                                 edges[i + 1] - edges[i], edges[j + 1] - edges[j]);
        }
    return shape;
}

double rms_difference(const ChunkShape& a, const ChunkShape& b) {
    const double ma = a.mean(), mb = b.mean();
    double sum = 0.0;
    for (std::size_t i = 0; i < 9; ++i) {
        const double d = (a.parts[i] - ma) - (b.parts[i] - mb);
        sum += d * d;
    }
    return std::sqrt(sum / 9.0);
}

void add_powers(std::array<double, 4>& powers, double value) {
    const double square = value * value;
    powers[0] += value, powers[1] += square;
    powers[2] += square * value, powers[3] += square * square;
}

// Slope is rise over run, curvature the Laplacian in 1/m.
void add_cell(Fitness::Sums& sums, double h, double west, double east, double north,
              double south, double spacing, double middle) {
    const double gx = (east - west) / (2.0 * spacing),
                 gy = (south - north) / (2.0 * spacing);
    sums.count += 1.0;
    add_powers(sums.powers[0], h - middle);
    add_powers(sums.powers[1], std::sqrt(gx * gx + gy * gy));
    add_powers(sums.powers[2],
               (west + east + north + south - 4.0 * h) / (spacing * spacing));
}

statistics::Statistics statistics_of(double n, const std::array<double, 4>& powers,
                                     double origin) {
    statistics::Statistics s;
    s.count = std::size_t(n);
    if (!(n > 3.0)) return s.count = 0, s;
    const double mean = powers[0] / n, b = powers[1] / n, c = powers[2] / n,
                 d = powers[3] / n;
    const double m2 = std::max(0.0, b - mean * mean);
    const double m3 = c - 3.0 * mean * b + 2.0 * mean * mean * mean;
    const double m4 =
        d - 4.0 * mean * c + 6.0 * mean * mean * b - 3.0 * mean * mean * mean * mean;
    s.mean = mean + origin, s.deviation = std::sqrt(m2);
    if (!(s.deviation > 1e-9 * std::abs(s.mean) + 1e-15)) return s;
    // With so many cells the k-statistics are the moments (eq. III.5 without n - 1).
    s.skewness = m3 / std::pow(m2, 1.5), s.kurtosis = m4 / (m2 * m2) - 3.0;
    return s;
}

}  // namespace

double ChunkShape::mean() const {
    double sum = 0.0;
    for (const double part : parts) sum += part;
    return sum / 9.0;
}
double ChunkShape::east() const {
    return (parts[2] + parts[5] + parts[8] - parts[0] - parts[3] - parts[6]) / 2.0;
}
double ChunkShape::north() const {
    return (parts[0] + parts[1] + parts[2] - parts[6] - parts[7] - parts[8]) / 2.0;
}

void Fitness::Sums::add(const Sums& other, double sign) {
    count += sign * other.count;
    for (std::size_t q = 0; q < powers.size(); ++q)
        for (std::size_t p = 0; p < 4; ++p) powers[q][p] += sign * other.powers[q][p];
}

Fitness::Fitness(const GeneGrid& grid, const LevelSamples& samples,
                 const Field<float>& pattern, const Regions& regions, Follows follows,
                 double alpha)
    : grid_(&grid),
      samples_(&samples),
      pattern_(&pattern),
      regions_(&regions),
      follows_(follows),
      alpha_(alpha) {
    learn_types();
    learn_pattern();
    learn_blocks();
}

void Fitness::learn_types() {
    types_.resize(samples_->of_type.size());
    std::vector<statistics::Type> types;
    for (std::size_t t = 0; t < types_.size(); ++t) {
        const auto& own = samples_->of_type[t];
        if (own.empty()) continue;
        TypeFacts& facts = types_[t];
        double low = 1e30, high = -1e30, steep = 0.0, gentle = 1e30, shapes = 0.0,
               details = 0.0, middle = 0.0, cells = 0.0;
        std::size_t chunks = 0;
        facts.absolute = false;
        for (const int index : own) {
            const Sample& sample = samples_->all[std::size_t(index)];
            const Field<float>& h = sample.land->heights;
            if (!sample.smaller) {
                const auto [least, most] = std::ranges::minmax(h);
                low = std::min(low, double(least)), high = std::max(high, double(most));
                middle +=
                    sample.land->mean(0, 0, h.width(), h.height()) * double(h.size());
                cells += double(h.size());
                facts.absolute = true;
            }
            for (const float d : sample.land->detail)
                details += double(d) * d * sample.gain * sample.gain / double(h.size());
            const int side = std::min({grid_->side, h.width(), h.height()});
            const int step = std::max(1, side / 2);
            for (int y = 0; y + side <= h.height(); y += step)
                for (int x = 0; x + side <= h.width(); x += step) {
                    const ChunkShape shape =
                        shape_in(*sample.land, {index, x, y}, side, sample.gain);
                    const double slope = std::hypot(shape.east(), shape.north());
                    steep = std::max(steep, slope), gentle = std::min(gentle, slope);
                    const ChunkShape flat;
                    const double r = rms_difference(shape, flat);
                    shapes += r * r, ++chunks;
                }
        }
        facts.elevation = kQuarter * std::max(1e-3, high - low);
        facts.slope = kQuarter * std::max(1e-3, steep - gentle);
        facts.shape =
            kHalf * std::sqrt(shapes / double(std::max<std::size_t>(1, chunks))) + 1e-3;
        facts.detail = kHalf * std::sqrt(details / double(own.size())) + 1e-3;
        facts.middle = cells > 0.0 ? middle / cells : 0.0;

        statistics::Type type{.name = {}, .examples = {}};
        for (const int index : own) {
            const Sample& sample = samples_->all[std::size_t(index)];
            const Field<float>& h = sample.land->heights;
            Sums sums;
            for (int y = 1; y + 1 < h.height(); ++y)
                for (int x = 1; x + 1 < h.width(); ++x)
                    add_cell(sums, sample.gain * h(x, y), sample.gain * h(x - 1, y),
                             sample.gain * h(x + 1, y), sample.gain * h(x, y - 1),
                             sample.gain * h(x, y + 1), samples_->spacing, facts.middle);
            statistics::Analysis analysis = analysis_of_sums(sums, int(t));
            if (sample.smaller)
                analysis[std::size_t(statistics::Quantity::kElevation)] = {};
            type.examples.push_back(analysis);
        }
        facts.in_library = int(types.size());
        types.push_back(std::move(type));
    }
    library_ = std::make_unique<statistics::Library>(std::move(types));
}

void Fitness::learn_pattern() {
    asked_.resize(grid_->slots.size());
    const auto edges = thirds(grid_->side);
    parallel_for(int(grid_->slots.size()), 64, [&](int slot) {
        const auto& s = grid_->slots[std::size_t(slot)];
        const int x0 = s.column * grid_->step(), y0 = s.row * grid_->step();
        for (std::size_t b = 0; b < 3; ++b)
            for (std::size_t a = 0; a < 3; ++a) {
                double sum = 0.0;
                for (int y = edges[b]; y < edges[b + 1]; ++y)
                    for (int x = edges[a]; x < edges[a + 1]; ++x)
                        sum += (*pattern_)(std::min(x0 + x, grid_->width - 1),
                                           std::min(y0 + y, grid_->height - 1));
                asked_[std::size_t(slot)].parts[3 * b + a] =
                    sum / ((edges[b + 1] - edges[b]) * (edges[a + 1] - edges[a]));
            }
    });
}

void Fitness::learn_blocks() {
    double total = 0.0;
    for (const std::size_t cells : regions_->cells) total += double(cells);
    for (const std::size_t cells : regions_->cells)
        shares_.push_back(double(cells) / total);
    block_regions_.resize(std::size_t(grid_->columns) * std::size_t(grid_->rows));
    std::vector<int> counts(regions_->types.size());
    for (int row = 0; row < grid_->rows; ++row)
        for (int column = 0; column < grid_->columns; ++column) {
            std::ranges::fill(counts, 0);
            const int x0 = column * grid_->step(), y0 = row * grid_->step();
            for (int y = y0; y < std::min(y0 + grid_->step(), grid_->height); ++y)
                for (int x = x0; x < std::min(x0 + grid_->step(), grid_->width); ++x)
                    ++counts[std::size_t(regions_->at(x, y))];
            block_regions_[std::size_t(block(column, row))] =
                int(std::ranges::max_element(counts) - counts.begin());
        }
}

const Fitness::TypeFacts& Fitness::facts(int slot) const {
    const int layer = grid_->slots[std::size_t(slot)].layer;
    return types_[std::size_t(grid_->types[std::size_t(layer)])];
}

ChunkShape Fitness::shape_of(const Gene& gene) const {
    const Sample& sample = samples_->all[std::size_t(gene.sample)];
    ChunkShape shape = shape_in(*sample.land, gene, grid_->side, sample.gain);
    const double mean = shape.mean();
    for (double& part : shape.parts) part = mean + gene.scale * (part - mean);
    return shape;
}

Compatibility Fitness::of_shapes(const ChunkShape& own, const ChunkShape& asked,
                                 const TypeFacts& type, bool absolute) const {
    Compatibility c;
    if (absolute) c.elevation = gaussian(own.mean() - asked.mean(), type.elevation);
    if (follows_ == Follows::kElevation) return c;
    const double slope = std::hypot(own.east(), own.north()),
                 wanted = std::hypot(asked.east(), asked.north());
    c.slope = gaussian(slope - wanted, type.slope);
    if (std::max(slope, wanted) > kLevel * type.slope / kQuarter)
        c.angle = gaussian(std::remainder(std::atan2(own.north(), own.east()) -
                                              std::atan2(asked.north(), asked.east()),
                                          2.0 * std::numbers::pi),
                           kQuarter * 2.0 * std::numbers::pi);
    c.shape = gaussian(rms_difference(own, asked), type.shape);
    return c;
}

Compatibility Fitness::compatibility(const Gene& gene, int slot) const {
    return of_shapes(shape_of(gene), asked_[std::size_t(slot)], facts(slot),
                     !samples_->all[std::size_t(gene.sample)].smaller);
}

Compatibility Fitness::compatibility(const Chromosome& chromosome, int slot) const {
    Compatibility c = compatibility(chromosome.gene(slot), slot);
    const auto& s = grid_->slots[std::size_t(slot)];
    double sum = 0.0;
    int count = 0;
    const auto add = [&](int of, bool north) {
        const float off = of < 0 ? -1.0f : chromosome.seam(of, north);
        if (off >= 0.0f) sum += seam(slot, off), ++count;
    };
    add(slot, false), add(slot, true);
    add(grid_->slot(s.layer, s.column + 1, s.row), false);
    add(grid_->slot(s.layer, s.column, s.row + 1), true);
    if (count > 0) c.seam = sum / count;
    return c;
}

double Fitness::seam(int slot, double off) const {
    return gaussian(off, facts(slot).detail);
}

double Fitness::range_of(int slot) const {
    const ChunkShape& asked = asked_[std::size_t(slot)];
    return std::abs(asked.east()) + std::abs(asked.north());
}

double Fitness::range_of(const Gene& gene) const {
    const ChunkShape shape = shape_of(gene);
    return std::abs(shape.east()) + std::abs(shape.north());
}

int Fitness::region_of_slot(int slot) const {
    const auto& s = grid_->slots[std::size_t(slot)];
    return region_of(block(s.column, s.row));
}

Fitness::Sums Fitness::sums(const Chromosome& chromosome, int block) const {
    const int column = block % grid_->columns, row = block / grid_->columns;
    const int step = grid_->step();
    const int x0 = column * step, y0 = row * step;
    const int x1 = column + 1 < grid_->columns ? x0 + step : grid_->width,
              y1 = row + 1 < grid_->rows ? y0 + step : grid_->height;
    // Including the surrounding cells, for slopes.
    const int left = std::max(0, x0 - 1), right = std::min(grid_->width, x1 + 1),
              top = std::max(0, y0 - 1), bottom = std::min(grid_->height, y1 + 1);
    const int w = right - left;
    thread_local std::vector<float> h;
    h.resize(std::size_t(w) * std::size_t(bottom - top));
    chromosome.detail(left, top, w, bottom - top, h.data());
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x)
            h[std::size_t(y - top) * std::size_t(w) + std::size_t(x - left)] +=
                (*pattern_)(x, y);

    const int region = region_of(block);
    const double middle =
        types_[std::size_t(regions_->types[std::size_t(region)])].middle;
    Sums sums;
    for (int y = std::max(y0, 1); y < std::min(y1, grid_->height - 1); ++y)
        for (int x = std::max(x0, 1); x < std::min(x1, grid_->width - 1); ++x) {
            if (regions_->at(x, y) != region) continue;
            const float* cell =
                h.data() + std::size_t(y - top) * std::size_t(w) + std::size_t(x - left);
            add_cell(sums, *cell, cell[-1], cell[1], cell[-w], cell[w], samples_->spacing,
                     middle);
        }
    return sums;
}

statistics::Analysis Fitness::analysis_of_sums(const Sums& sums, int type) const {
    statistics::Analysis analysis{};
    for (std::size_t q = 0; q < kJudged.size(); ++q)
        analysis[std::size_t(kJudged[q])] = statistics_of(
            sums.count, sums.powers[q], q == 0 ? types_[std::size_t(type)].middle : 0.0);
    return analysis;
}

double Fitness::similarity(int region, const Sums& sums) const {
    const int type = regions_->types[std::size_t(region)];
    const TypeFacts& facts = types_[std::size_t(type)];
    if (facts.in_library < 0 || sums.count < 4.0) return 1.0;
    statistics::Analysis analysis = analysis_of_sums(sums, type);
    if (!facts.absolute) analysis[std::size_t(statistics::Quantity::kElevation)] = {};
    return library_->similarity(std::size_t(facts.in_library), analysis);
}

double Fitness::similarity(const std::vector<double>& of_regions) const {
    double sum = 0.0;
    for (std::size_t r = 0; r < of_regions.size(); ++r) sum += shares_[r] * of_regions[r];
    return sum;
}

}  // namespace cydonia::genetic
