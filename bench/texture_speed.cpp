// What a texture stage costs once its database is loaded (docs/your-own-mountains.md):
//     texture_speed EXEMPLAR
// 1024 x 1024 samples without constraints, with 20 curves, 5 points and 3 painted types
// and how far from them the land is, and 4096 x 4096 with the most memory held.

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "bench/measure.h"
#include "field/image.h"
#include "field/random.h"
#include "synth/texture/constraints/constraint_errors.h"
#include "synth/texture/maker.h"

using namespace cydonia;
using namespace cydonia::texture;

namespace {

double drawn(const char* what, int i, int j = 0) {
    return unit(hash_of({key(what), std::uint64_t(i), std::uint64_t(j)}));
}

// Curves that wander over the land, their heights within the exemplar's.
void add_constraints(Options& options, double side, double low, double high,
                     const std::filesystem::path& folder) {
    const auto height = [&](int i, int j) {
        return low + (0.2 + 0.6 * drawn("height", i, j)) * (high - low);
    };
    for (int i = 0; i < 20; ++i) {
        geometry::Curve curve{.name = fmt::format("curve {}", i + 1)};
        const double x = drawn("x", i), y = drawn("y", i);
        for (int j = 0; j < 4; ++j)
            curve.points.push_back(
                {metres(side * std::clamp(x + 0.1 * j * (2 * drawn("u", i) - 1), 0., 1.)),
                 metres(side *
                        std::clamp(y + 0.1 * j * (2 * drawn("v", i) - 1), 0., 1.))});
        curve.handles = {{.at = 0.0, .height = height(i, 0)},
                         {.at = 1.0, .height = height(i, 1)}};
        options.curves.push_back(curve);
    }
    for (int i = 0; i < 5; ++i)
        options.points.push_back(
            {.name = fmt::format("point {}", i + 1),
             .at = {metres(side * drawn("px", i)), metres(side * drawn("py", i))},
             .height = height(i, 2)});
    options.types = {
        {"calm", {0, 0, 255}}, {"hills", {0, 255, 0}}, {"rugged", {255, 0, 0}}};
    options.automatic_types = true;
    Field<Rgb8> bands(300, 300);
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 300; ++x)
            bands(x, y) = options.types[std::size_t(x / 100)].colour;
    write_png(folder / "bands.png", bands);
    options.paint = open_source(folder / "bands.png");
}

struct Timed {
    double median = 0.0;
    Field<float> heights;
    ConstraintErrors errors;
};

// All of a stage but its report; the first run makes the database.
Timed timed(const Options& options, int side, double spacing, const Context& context,
            int runs) {
    const Extent extent{side, side, spacing};
    Timed timed;
    std::vector<double> seconds;
    for (int i = 0; i <= runs; ++i) {
        const bench::Stopwatch watch;
        const Maker maker(options, extent, context);
        const Synthesis land =
            synthesised(maker.database(), maker.controls(), maker.guidance(),
                        maker.window_of(0, 0, side, side), nullptr, *context.progress);
        timed.heights = maker.heights(land, 0, 0, side, side);
        if (i > 0) seconds.push_back(watch.seconds());
        if (i == runs && !maker.geometry().empty())
            timed.errors = constraint_errors(maker.geometry(), timed.heights, spacing);
    }
    std::ranges::nth_element(seconds, seconds.begin() + std::ssize(seconds) / 2);
    timed.median = seconds[seconds.size() / 2];
    return timed;
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        fmt::print(stderr, "usage: texture_speed EXEMPLAR\n");
        return 2;
    }
    SilentProgress silent;
    Context context;
    context.seed = 1;
    context.progress = &silent;
    const bench::ScratchFolder folder;
    context.cache = folder.path();
    Options options;
    options.exemplars = {{open_source(arguments[1]), {}, {}}};
    double spacing = 0.0, low = 0.0, high = 0.0;
    {
        const Maker maker(options, {64, 64, 1.0}, context);
        spacing = maker.database().spacing;
        low = maker.database().lowest;
        high = maker.database().highest;
    }

    const Timed plain = timed(options, 1024, spacing, context, 5);
    fmt::print("1024x1024, no constraints: {:.3f} s\n", plain.median);
    Options asked = options;
    add_constraints(asked, 1024 * spacing, low, high, context.cache);
    const Timed constrained = timed(asked, 1024, spacing, context, 5);
    const auto [least, most] = std::ranges::minmax(constrained.heights);
    fmt::print("1024x1024, 20 curves, 5 points, 3 types: {:.3f} s\n", constrained.median);
    fmt::print("constraint error: RMS {:.1f} m, most {:.1f} m, of {:.0f} m: {:.2f} %\n",
               constrained.errors.all.rms, constrained.errors.all.max,
               double(most - least), 100.0 * constrained.errors.all.rms / (most - least));
    const Timed large = timed(options, 4096, spacing, context, 1);
    fmt::print("4096x4096: {:.2f} s, {:.2f} GiB at most\n", large.median,
               bench::peak_mebibytes() / 1024.0);
}
