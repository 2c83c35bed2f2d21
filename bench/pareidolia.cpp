// The whole table of the shadow images: every image of a folder hidden in a mountain
// range of the distance method and in real elevation models, then checked.
//
//     build/bench/bench/pareidolia FOLDER [SAMPLES] [--base DEM.tif]... [--look FOLDER]
//                                  [--only PART]... [--times] [--no-two] [--no-features]
//
// Columns: IoU at 2x2, 4x4 and 1x1 samples a cell, of the whole frame and of the sun's
// disc; precision, recall, outline F-score, recall of thin parts; correlation away from
// the base's own with the sun turned by 30 and 90 degrees and raised to 45 (r); outline
// in the shading, and the base's (edge, edge0); how far the image stands out under its
// sun and at most under others (z); kurtosis of the land and of the base; slope and range
// as multiples of the base's; seconds of the solver and the hard check; IoU and seconds
// of the thesis' solver at 256 samples. docs/shadow-check.md says how they are measured.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/measure.h"
#include "field/dem.h"
#include "field/error.h"
#include "field/files.h"
#include "field/image.h"
#include "field/quantise.h"
#include "render/maps/hillshade.h"
#include "render/shadow/figures.h"
#include "render/shadow/overlay.h"
#include "synth/pareidolia/constrained/contradictions.h"
#include "synth/stage.h"

using namespace cydonia;
namespace fs = std::filesystem;

namespace {

constexpr double kElevation = 25.0;  // degrees
constexpr double kExtent = 5120.0;   // metres
constexpr std::uint64_t kSeed = 7;

using Mask = Field<std::uint8_t>;

struct Request {
    fs::path folder;
    int samples = 512;
    std::vector<fs::path> bases;
    fs::path look;
    std::vector<std::string> only;  // images whose names hold one of these
    bool times = false, two = true, features = true;
};

// As the program runs a stage (app/pipeline/land.cpp).
Mask cast(const Terrain& terrain, const Sun& sun, int rays) {
    return render::Caster(heights_of(quantised(terrain.heights)), terrain.spacing)
        .shadow(sun, rays);
}

Terrain run_stage(const StageOptions& options, const Terrain& terrain) {
    SilentProgress silent;
    return run(options, terrain,
               {.seed = kSeed,
                .cast = cast,
                .progress = &silent,
                .explain = nullptr,
                .memory = nullptr});
}

Terrain flat(int samples) {
    return {Field<float>(samples, samples), kExtent / samples, {}, {}, {}};
}

// As scenes/mountain-range, without its drawn valleys.
Terrain mountain_range(int samples) {
    distance::Options options;
    options.mean_edge_weight = 1.0;
    options.edge_weight_deviation = 0.75;
    options.sea_level_scale = 1.01;
    options.blending_bias = 4.0;
    options.neighbours = 16;
    options.vertical_scale = 2.0;
    const auto profile = [&](const char* name,
                             std::vector<std::array<double, 2>> points) {
        distance::Profile added;
        added.name = name;
        added.curve.points = std::move(points);
        options.profiles.push_back(added);
    };
    profile(
        "blunt",
        {{0, 1.0}, {5, 0.95}, {14, 0.78}, {26, 0.46}, {40, 0.18}, {55, 0.05}, {72, 0.0}});
    profile("sharp", {{0, 1.0}, {9, 0.76}, {20, 0.48}, {34, 0.23}, {48, 0.07}, {62, 0}});
    profile("steep", {{0, 1.0}, {5, 0.76}, {12, 0.52}, {22, 0.28}, {36, 0.09}, {52, 0}});
    distance::Group peaks;
    peaks.name = "peaks";
    distance::Peaks where;
    where.placement.count = 100;
    peaks.where = where;
    peaks.ridges.count = 150;
    peaks.ridges.cost_factor = 0.5;
    peaks.ridges.reach = metres(350.0);
    peaks.profile = {"blunt", "sharp", "steep"};
    options.groups = {peaks};
    return run_stage(options, flat(samples));
}

// The middle of a model, as large as fits, in so many samples.
Terrain middle_of(const fs::path& file, int samples) {
    const Terrain whole = read_dem(open_source(file));
    const int side = std::min({samples, whole.heights.width(), whole.heights.height()});
    const int x0 = (whole.heights.width() - side) / 2;
    const int y0 = (whole.heights.height() - side) / 2;
    Field<float> middle(side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) middle(x, y) = whole.heights(x0 + x, y0 + y);
    Terrain land;
    land.spacing = whole.spacing * side / samples;
    land.heights = side == samples ? middle : resized(middle, samples, samples);
    return land;
}

struct Base {
    std::string name;
    Terrain land;
};

std::vector<Base> bases_of(const Request& request, int samples) {
    std::vector<Base> bases{{"mountain range", mountain_range(samples)}};
    for (const fs::path& file : request.bases)
        bases.push_back({file.stem().string(), middle_of(file, samples)});
    return bases;
}

std::vector<Source> images_of(const Request& request) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(request.folder)) {
        const std::string name = entry.path().filename().string();
        const std::string kind = entry.path().extension().string();
        const bool wanted = std::ranges::any_of(request.only, [&](const auto& part) {
            return name.find(part) != std::string::npos;
        });
        if ((kind == ".png" || kind == ".svg") && (request.only.empty() || wanted))
            files.push_back(entry.path());
    }
    std::ranges::sort(files);
    if (files.empty()) throw bad_request("{}: no PNG, no SVG", request.folder.string());
    std::vector<Source> images;
    for (const fs::path& file : files) images.push_back(open_source(file));
    return images;
}

// --- one image -----------------------------------------------------------------------

pareidolia::ImageOptions image_options(const Source& target,
                                       std::optional<double> azimuth = std::nullopt,
                                       double elevation = kElevation) {
    pareidolia::ImageOptions image;
    image.target = target;
    image.elevation = radians(elevation);
    if (azimuth) image.azimuth = radians(*azimuth);
    return image;
}

pareidolia::Options constrained(std::vector<pareidolia::ImageOptions> images) {
    pareidolia::Options options;
    options.solver = pareidolia::Solver::kConstrained;
    options.images = std::move(images);
    return options;
}

struct Hidden {
    Terrain land;
    double seconds = 0.0;  // of the solver and the hard 2x2 check
};

Hidden hidden(const pareidolia::Options& options, const Terrain& base) {
    const bench::Stopwatch watch;
    Hidden result{run_stage(options, base)};
    const render::CheckedLand land(result.land.heights, result.land.spacing);
    for (const ShadowImage& image : result.land.shadows)
        render::score(land.caster.shadow(image.sun, 2), image.target, image.window);
    result.seconds = watch.seconds();
    return result;
}

// Pictures of one land, to look at.
void look(const Request& request, const std::string& name, const Terrain& base,
          const Terrain& land) {
    if (request.look.empty()) return;
    make_folder(request.look);
    const auto write = [&](const std::string& what, const Field<Rgb8>& picture) {
        write_png(request.look / fmt::format("{}-{}.png", name, what), picture);
    };
    write("base", render::hillshade(base));
    write("land", render::hillshade(land));
    const render::CheckedLand checked(land.heights, land.spacing);
    const Field<float> relief = render::relief(checked.heights, checked.spacing);
    int i = 0;
    for (const ShadowImage& image : land.shadows)
        write(fmt::format("overlay-{}", ++i),
              render::overlay(checked.caster.shadow(image.sun, 2), image, relief));
}

// --- the table -----------------------------------------------------------------------

// A figure: its name, how wide it prints, and what is asked of its mean and of its worst.
struct Column {
    const char* name;
    int digits;
    bool more_is_better;
    std::optional<double> mean, worst;
};
constexpr double kNone = -1e9;

const std::vector<Column> kColumns = {
    {"2x2", 4, true, 0.985, 0.965}, {"4x4", 4, true, {}, {}},
    {"1x1", 4, true, 0.998, {}},    {"frame", 3, true, {}, {}},
    {"soft", 4, true, {}, {}},      {"prec", 4, true, {}, {}},
    {"recall", 4, true, {}, {}},    {"F", 4, true, {}, {}},
    {"thin", 3, true, {}, {}},      {"r30", 3, false, 0.15, {}},
    {"r90", 3, false, 0.05, {}},    {"r45up", 3, false, 0.15, {}},
    {"edge", 2, false, 1.3, {}},    {"edge0", 2, false, {}, {}},
    {"z", 1, true, {}, 10.0},       {"z-else", 1, false, {}, 2.0},
    {"kurt", 1, false, {}, 15.0},   {"kurt0", 1, false, {}, {}},
    {"slope", 2, false, {}, 1.3},   {"range", 2, false, {}, 1.5},
    {"s", 2, false, 2.0, {}},       {"feat", 3, true, {}, {}},
    {"feat-s", 2, false, 0.3, {}},
};
using Row = std::vector<double>;

std::string cell(const Column& column, double value) {
    return value == kNone ? fmt::format("{:>7}", "")
                          : fmt::format("{:7.{}f}", value, column.digits);
}

void print_names() {
    fmt::print("{:16}", "");
    for (const Column& column : kColumns) fmt::print("{:>7}", column.name);
    fmt::print("\n");
}

void print_row(const std::string& name, const Row& row) {
    fmt::print("{:16.15}", name);
    for (std::size_t i = 0; i < row.size(); ++i)
        fmt::print("{}", cell(kColumns[i], row[i]));
    fmt::print("\n");
    std::fflush(stdout);
}

Row row_of(const render::ShadowFigures& f, double seconds) {
    const auto& base = f.base.value();
    return {f.fine.iou,
            f.iou_4x4,
            f.iou_1x1,
            f.iou_frame,
            f.iou_soft,
            f.fine.precision,
            f.fine.recall,
            f.outline,
            f.thin_recall.value_or(kNone),
            hiddenness(f, 30.0),
            hiddenness(f, 90.0),
            hiddenness(f, 0.0),
            outline_ratio(f),
            outline_ratio_of_base(f),
            f.standing_out,
            worst_standing_out(f),
            f.land.kurtosis,
            base.kurtosis,
            f.land.slope / base.slope,
            f.land.range / base.range,
            seconds,
            kNone,
            kNone};
}

// Mean and worst of every column, and what is asked of them.
void print_summary(const std::vector<Row>& rows) {
    Row mean, worst, asked_mean, asked_worst;
    std::string short_of;
    for (std::size_t c = 0; c < kColumns.size(); ++c) {
        const Column& column = kColumns[c];
        double sum = 0.0, least = kNone;
        int count = 0;
        for (const Row& row : rows) {
            if (row[c] == kNone) continue;
            sum += row[c];
            if (count++ == 0 || (row[c] < least) == column.more_is_better) least = row[c];
        }
        mean.push_back(count ? sum / count : kNone);
        worst.push_back(least);
        asked_mean.push_back(column.mean.value_or(kNone));
        asked_worst.push_back(column.worst.value_or(kNone));
        const auto check = [&](const char* what, double value, double asked) {
            if (count == 0 || asked == kNone || value == asked) return;
            if ((value > asked) != column.more_is_better)
                short_of += fmt::format("  {} {}: {:.3f}, asked {}\n", what, column.name,
                                        value, asked);
        };
        check("mean", mean.back(), asked_mean.back());
        check("worst", worst.back(), asked_worst.back());
    }
    print_row("mean", mean);
    print_row("  asked", asked_mean);
    print_row("worst", worst);
    print_row("  asked", asked_worst);
    fmt::print("{}\n",
               short_of.empty() ? "all met" : "short of what is asked:\n" + short_of);
}

// The thesis' own solver at its own size, on a base calm enough for it.
void add_features(const Source& target, Row& row) {
    static const Terrain base = [] {
        distance::Options options;
        options.mean_edge_weight = 0.35;
        options.edge_weight_deviation = 0.25;
        options.grain = metres(40.0);
        options.sea_level_scale = 1.0;
        distance::Group peaks;
        distance::Peaks where;
        where.placement.count = 1311;
        peaks.where = where;
        peaks.cost.kind = distance::CostRule::Kind::kRandom;
        peaks.cost.range = {metres(0.0), of_width(0.015)};
        peaks.ridges.count = 200;
        options.groups = {peaks};
        return run_stage(options, flat(256));
    }();
    pareidolia::Options options;
    options.images = {image_options(target)};
    options.features.mean_edge_weight = 1.2;
    options.features.edge_weight_deviation = 0.8;
    options.features.grain = metres(80.0);
    const Hidden made = hidden(options, base);
    const ShadowImage& image = made.land.shadows.front();
    const std::size_t columns = row.size();
    row[columns - 2] =
        render::score(cast(made.land, image.sun, 2), image.target, image.window).iou;
    row[columns - 1] = made.seconds;
}

void single_images(const Request& request, const std::vector<Source>& images) {
    std::vector<Row> rows;
    for (const Base& base : bases_of(request, request.samples)) {
        fmt::print("\none image, sun at {} degrees, {} samples, base: {}\n", kElevation,
                   request.samples, base.name);
        print_names();
        const render::CheckedLand before(base.land.heights, base.land.spacing);
        for (const Source& target : images) {
            const Hidden made = hidden(constrained({image_options(target)}), base.land);
            const render::CheckedLand land(made.land.heights, made.land.spacing);
            Row row = row_of(shadow_figures(land, &before, made.land.shadows.front()),
                             made.seconds);
            if (request.features && rows.size() < images.size())
                add_features(target, row);
            const std::string name = target.path.stem().string();
            print_row(name, row);
            rows.push_back(row);
            look(request, base.name + "-" + name, base.land, made.land);
        }
    }
    fmt::print("\nover all bases\n");
    print_names();
    print_summary(rows);
}

// --- two suns ------------------------------------------------------------------------

using Pair = std::vector<pareidolia::ImageOptions>;

void print_pair(const std::string& name, const Hidden& made, const Terrain& base,
                std::vector<double>& ious, std::vector<double>& gaps) {
    const render::CheckedLand land(made.land.heights, made.land.spacing);
    const render::CheckedLand before(base.heights, base.spacing);
    fmt::print("{:32.31}", name);
    double mean = 0.0;
    for (const ShadowImage& image : made.land.shadows) {
        const auto f = shadow_figures(land, &before, image);
        fmt::print("  {:6.4f} {:6.4f} {:5.1f}% {:6.1f}", f.fine.iou, f.iou_1x1,
                   100.0 * f.relaxed.share, f.standing_out);
        ious.push_back(f.fine.iou);
        mean += f.fine.iou / static_cast<double>(made.land.shadows.size());
    }
    // What no land can do, whatever this one gave up.
    std::vector<ShadowImage> asked = made.land.shadows;
    for (ShadowImage& image : asked) image.relaxed = {};
    const double bound = pareidolia::settle(asked).bound;
    gaps.push_back(bound - mean);
    fmt::print("  {:6.4f} {:6.4f}  {:6.2f}\n", mean, bound, made.seconds);
    std::fflush(stdout);
}

// Pairs of consecutive images, on the first base.
void two_images(const Request& request, const Terrain& base,
                const std::vector<Source>& images, const std::string& title,
                const std::function<Pair(const Source&, const Source&)>& pair) {
    fmt::print("\n{}\n{:32}", title, "");
    for (int i = 0; i < 2; ++i)
        fmt::print("  {:>6} {:>6} {:>6} {:>6}", "2x2", "1x1", "gave", "z");
    fmt::print("  {:>6} {:>6}  {:>6}\n", "mean", "bound", "s");
    std::vector<double> ious, gaps;
    const auto hide = [&](const Source& a, const Source& b) {
        const std::string name = a.path.stem().string() + " + " + b.path.stem().string();
        const Hidden made = hidden(constrained(pair(a, b)), base);
        print_pair(name, made, base, ious, gaps);
        look(request, title.substr(0, title.find(',')) + "-" + name, base, made.land);
    };
    for (std::size_t i = 0; i + 1 < images.size(); i += 2) hide(images[i], images[i + 1]);
    double mean = 0.0;
    for (const double iou : ious) mean += iou / static_cast<double>(ious.size());
    fmt::print("mean 2x2 {:.4f}, worst {:.4f}; farthest below the bound {:.4f}\n", mean,
               std::ranges::min(ious), std::ranges::max(gaps));
}

Pair side_by_side(const Source& a, const Source& b) {
    Pair pair{image_options(a, 330.0), image_options(b, 30.0)};
    pair[0].placing = {.position = {0.26, 0.5}, .scale = 0.46, .rotation = 0.0};
    pair[1].placing = {.position = {0.74, 0.5}, .scale = 0.46, .rotation = 0.0};
    return pair;
}

// What the high sun shows, small in the middle, the low sun shows too, within the first:
// where a steep shadow ends, a flat one goes on for a while or land must climb out of it.
Pair nested(const Source& a, const Source& b, const fs::path& scratch) {
    constexpr int kSide = 1024, kSmall = kSide * 3 / 10, kAt = (kSide - kSmall) / 2;
    Field<float> both = resized(read_grey(a), kSide, kSide);
    const Field<float> inner = resized(read_grey(b), kSmall, kSmall);
    for (int y = 0; y < kSmall; ++y)
        for (int x = 0; x < kSmall; ++x)
            both(kAt + x, kAt + y) = std::min(both(kAt + x, kAt + y), inner(x, y));
    Mask levels(kSide, kSide);
    for (std::size_t i = 0; i < both.size(); ++i) levels[i] = both[i] < 0.5f ? 0 : 255;
    const fs::path file = scratch / fmt::format("{}-and-{}.png", a.path.stem().string(),
                                                b.path.stem().string());
    write_png(file, levels);
    Pair pair{image_options(open_source(file), 0.0, 20.0), image_options(b, 0.0, 26.0)};
    pair[1].placing = {.position = {0.5, 0.5}, .scale = 0.3, .rotation = 0.0};
    return pair;
}

Pair overlapping(const Source& a, const Source& b) {
    return {image_options(a, 35.0), image_options(b, 125.0)};
}

void two_suns(const Request& request, const std::vector<Source>& images) {
    if (images.size() < 2) return;
    const Terrain base = mountain_range(request.samples);
    const bench::ScratchFolder scratch;
    two_images(request, base, images,
               "side by side, suns at 330 and 30 degrees: mean 2x2 at least 0.975",
               side_by_side);
    two_images(
        request, base, images,
        "nested, one azimuth, sun at 20 and 26 degrees: mean 2x2 at least 0.975",
        [&](const Source& a, const Source& b) { return nested(a, b, scratch.path()); });
    two_images(request, base, images,
               "overlapping, suns at 90 degrees: their mean within 0.03 of its bound",
               overlapping);
}

// --- time ----------------------------------------------------------------------------

void times(const std::vector<Source>& images) {
    const std::map<int, double> asked{{512, 2.0}, {1024, 7.0}, {2048, 40.0}};
    fmt::print("\nseconds with the hard 2x2 check, mean of {} images\n",
               std::min<std::size_t>(3, images.size()));
    for (const auto& [samples, most] : asked) {
        const Terrain base = mountain_range(samples);
        double sum = 0.0;
        int count = 0;
        for (const Source& target : images) {
            if (count == 3) break;
            sum += hidden(constrained({image_options(target)}), base).seconds;
            ++count;
        }
        fmt::print(
            "{0:>5} x {0:<5} {1:7.2f} s, asked {2:4.0f} s; peak memory so far {3:.0f} "
            "MiB\n",
            samples, sum / count, most, bench::peak_mebibytes());
        std::fflush(stdout);
    }
}

Request request_of(int argc, char** argv) {
    Request request;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const auto value = [&]() -> std::string {
            if (i + 1 >= argc) throw bad_request("{} needs a value", word);
            return argv[++i];
        };
        if (word == "--base") {
            request.bases.push_back(value());
        } else if (word == "--look") {
            request.look = value();
        } else if (word == "--only") {
            request.only.push_back(value());
        } else if (word == "--times") {
            request.times = true;
        } else if (word == "--no-two") {
            request.two = false;
        } else if (word == "--no-features") {
            request.features = false;
        } else if (word.starts_with("--")) {
            throw bad_request("no such option: {}", word);
        } else if (request.folder.empty()) {
            request.folder = word;
        } else {
            request.samples = std::stoi(word);
        }
    }
    if (!fs::is_directory(request.folder) || request.samples < 64 ||
        request.samples > 8192)
        throw bad_request("pareidolia FOLDER [SAMPLES, 64 to 8192] [--base DEM]...");
    return request;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const Request request = request_of(argc, argv);
        const std::vector<Source> images = images_of(request);
        single_images(request, images);
        if (request.two) two_suns(request, images);
        if (request.times) times(images);
        return 0;
    } catch (const Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return static_cast<int>(error.code());
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    }
}
