#include "app/library.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "app/library_analyst.h"
#include "app/library_plot.h"
#include "app/library_types.h"
#include "app/pipeline/output_folder.h"
#include "app/threads.h"
#include "config/reader/library.h"
#include "field/error.h"
#include "field/files.h"
#include "synth/statistics/similarity.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

using statistics::Analysis;
using statistics::Library;
using statistics::Quantity;

// A library at one level of detail; types that have no example there are left out.
struct Level {
    double spacing;
    Library library;
};

// What a type with few examples cannot tell.
void say_few(const genetic::TypeOptions& type, const std::vector<Level>& levels,
             Console& console) {
    std::size_t most = 0;
    for (const Level& level : levels)
        for (const statistics::Type& own : level.library.types())
            if (own.name == type.name) most = std::max(most, own.examples.size());
    if (type.examples.empty())
        console.warn(fmt::format("'{}' has no examples: nothing is like it", type.name));
    else if (most == 0)
        console.warn(fmt::format(
            "'{}' has no example that is fine and large enough at any level", type.name));
    else if (most == 1)
        console.note(fmt::format(
            "'{}' has one example, which cannot tell how far others differ from it: as "
            "far as those of other types",
            type.name));
}

std::vector<Level> levels_of(const genetic::LibraryOptions& options, Analyst& analyst,
                             Console& console) {
    // Level by level of one model, so that it is read once.
    std::vector<std::vector<statistics::Type>> types(options.levels.size());
    double done = 0.0, all = 0.0;
    for (const auto& type : options.types) all += double(type.examples.size());
    for (const auto& type : options.types) {
        for (auto& level : types) level.push_back({type.name, {}, type.colour});
        for (const genetic::Example& example : type.examples) {
            for (std::size_t l = 0; l < types.size(); ++l)
                if (const auto analysis = analyst(example, options.levels[l]))
                    types[l].back().examples.push_back(*analysis);
            console.report(++done / std::max(1.0, all));
        }
    }
    std::vector<Level> levels;
    for (std::size_t l = 0; l < types.size(); ++l) {
        std::erase_if(types[l],
                      [](const statistics::Type& type) { return type.examples.empty(); });
        if (!types[l].empty()) levels.push_back({options.levels[l], Library(types[l])});
    }
    for (const auto& type : options.types) say_few(type, levels, console);
    if (levels.empty())
        throw bad_request(
            "{}: no example is fine and large enough at any level ({} samples a side)",
            options.name, kFewestSamples);
    return levels;
}

constexpr std::size_t kLongestName = 48, kColumns = 9;  // that 80 characters hold

// At most so many bytes of a name, whole characters.
std::string shortened(const std::string& name) {
    std::size_t end = std::min(kLongestName, name.size());
    while (end < name.size() && end > 0 && (name[end] & 0xc0) == 0x80) --end;
    return name.substr(0, end);
}

// The types with their numbers; a line of each says `rest`.
void print_types_of(const Level& level, std::string_view head,
                    const std::function<std::string(std::size_t)>& rest) {
    const std::vector<statistics::Type>& types = level.library.types();
    std::size_t width = 8;
    for (const statistics::Type& type : types)
        width = std::max(width, std::min(kLongestName, type.name.size()));
    fmt::print("{:g} m\n{:{}}  {}\n", level.spacing, "", width + 6, head);
    for (std::size_t t = 0; t < types.size(); ++t)
        fmt::print("  {:2}  {:{}}  {}\n", t + 1, shortened(types[t].name), width,
                   rest(t));
}

// A row a quantity, a column a type, by their numbers; the next types below.
void print_quantities(const Library& library,
                      const std::function<double(std::size_t, Quantity)>& value) {
    const std::size_t count = library.types().size();
    for (std::size_t first = 0; first < count; first += kColumns) {
        const std::size_t last = std::min(count, first + kColumns);
        fmt::print("  {:15}", "");
        for (std::size_t t = first; t < last; ++t) fmt::print("  {:>4}", t + 1);
        fmt::print("\n");
        for (int q = 0; q < statistics::kQuantities; ++q) {
            fmt::print("  {:15}", statistics::kQuantityNames[std::size_t(q)]);
            for (std::size_t t = first; t < last; ++t)
                fmt::print("  {:>4.2f}", value(t, Quantity(q)));
            fmt::print("\n");
        }
    }
}

// Where its plots and analyses go.
fs::path folder_of(const LibraryRequest& request) {
    return request.output.empty() ? fs::path("out") / request.library.stem()
                                  : request.output;
}

void run(const LibraryRequest& request, Console& console,
         const std::function<void(const genetic::LibraryOptions&, Analyst&)>& work) {
    with_threads(request.threads, [&] {
        const genetic::LibraryOptions options = config::load_library(request.library);
        const fs::path folder = folder_of(request);
        const OutputFolder claim(folder);
        Analyst analyst(folder / ".cache" / "analyses", console);
        work(options, analyst);
        console.note("plots in " + folder.string());
    });
}

void plot(const LibraryRequest& request, const Level& level, const std::string& name,
          const Analysis* land = nullptr) {
    write_text(folder_of(request) / fmt::format("{}-{:g}m.svg", name, level.spacing),
               library_plot(level.library, level.spacing,
                            request.land.filename().string(), land));
}

// Of the land, at the levels that it and the library have.
std::vector<std::pair<Level, Analysis>> analysed(const LibraryRequest& request,
                                                 const std::vector<Level>& levels,
                                                 Analyst& analyst) {
    const genetic::Example land{open_source(request.land)};
    std::vector<std::pair<Level, Analysis>> all;
    for (const Level& level : levels)
        if (const auto analysis = analyst(land, level.spacing))
            all.emplace_back(level, *analysis);
    if (all.empty())
        throw bad_request(
            "{}: at none of the library's levels is it fine and large enough ({} samples "
            "a side)",
            request.land.string(), kFewestSamples);
    return all;
}

// The coarsest level at which the land has many windows; else its finest.
double segmented_level(const std::vector<std::pair<Level, Analysis>>& levels,
                       std::size_t enough = 256 * 256) {
    for (const auto& [level, land] : levels)
        if (land[std::size_t(Quantity::kElevation)].count >= enough) return level.spacing;
    return levels.back().first.spacing;
}

// What types the land is made of, on a map.
void cut_into_types(const LibraryRequest& request, const genetic::LibraryOptions& options,
                    double spacing, Analyst& analyst, Console& console) {
    std::vector<statistics::Type> types;
    for (const auto& type : options.types) {
        types.push_back({type.name, {}, type.colour});
        for (const genetic::Example& example : type.examples)
            if (analyst(example, spacing))
                std::ranges::copy(analyst.windows(example, spacing),
                                  std::back_inserter(types.back().examples));
    }
    const Library library(std::move(types));
    auto land = analyst.studied({open_source(request.land)}, spacing);
    console.finish();
    if (!land) return;
    const TypeMap map = type_map(library, std::move(*land));
    const fs::path file =
        folder_of(request) / (request.land.stem().string() + "-types.png");
    write_type_picture(file, library, map);
    if (print_types(library, map, request.land))
        console.warn(fmt::format("{} is of several types; the map is {}",
                                 request.land.string(), file.string()));
}

}  // namespace

void analyse_library(const LibraryRequest& request, Console& console) {
    run(request, console, [&](const auto& options, Analyst& analyst) {
        const std::vector<Level> levels = levels_of(options, analyst, console);
        console.finish();
        for (const Level& level : levels) {
            const Library& library = level.library;
            plot(request, level, "library");
            print_types_of(level, "examples   own  other", [&](std::size_t t) {
                double own = 1.0, other = 0.0;
                for (const Analysis& example : library.types()[t].examples)
                    for (std::size_t u = 0; u < library.types().size(); ++u) {
                        const double like = library.similarity(u, example);
                        if (u == t)
                            own = std::min(own, like);
                        else
                            other = std::max(other, like);
                    }
                return fmt::format("{:>8}  {:.2f}  {:>5.2f}",
                                   library.types()[t].examples.size(), own, other);
            });
            print_quantities(library, [&](std::size_t t, Quantity q) {
                return library.agreement(t, q);
            });
        }
        fmt::print(
            "How like their own type its examples are at least, and how like another at\n"
            "most; of each quantity how far they agree. All from 0 to 1.\n");
    });
}

void compare_with_library(const LibraryRequest& request, Console& console) {
    run(request, console, [&](const auto& options, Analyst& analyst) {
        const auto levels =
            analysed(request, levels_of(options, analyst, console), analyst);
        console.finish();
        for (const auto& [level, land] : levels) {
            const Library& library = level.library;
            plot(request, level, "compared", &land);
            print_types_of(level, " all", [&](std::size_t t) {
                return fmt::format("{:.2f}", library.similarity(t, land));
            });
            print_quantities(library, [&](std::size_t t, Quantity q) {
                return library.likeness(t, q, land).similarity;
            });
        }
    });
}

void classify_by_library(const LibraryRequest& request, Console& console) {
    run(request, console, [&](const auto& options, Analyst& analyst) {
        const auto levels =
            analysed(request, levels_of(options, analyst, console), analyst);
        console.finish();
        for (const auto& [level, land] : levels) {
            const Library& library = level.library;
            plot(request, level, "compared", &land);
            std::size_t best = 0;
            for (std::size_t t = 1; t < library.types().size(); ++t)
                if (library.similarity(t, land) > library.similarity(best, land))
                    best = t;
            fmt::print("{:g} m: {} ({:.2f})\n", level.spacing, library.types()[best].name,
                       library.similarity(best, land));
            const Library more = library.with(best, land);
            for (int q = 0; q < statistics::kQuantities; ++q)
                fmt::print("  {:15}  agreement {:.2f}, with it {:.2f}\n",
                           statistics::kQuantityNames[std::size_t(q)],
                           library.agreement(best, Quantity(q)),
                           more.agreement(best, Quantity(q)));
        }
        cut_into_types(request, options, segmented_level(levels), analyst, console);
    });
}

}  // namespace cydonia
