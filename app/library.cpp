#include "app/library.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/library_plot.h"
#include "app/pipeline/cache.h"
#include "app/pipeline/output_folder.h"
#include "app/threads.h"
#include "config/reader/library.h"
#include "field/dem.h"
#include "field/error.h"
#include "field/files.h"
#include "synth/genetic/similarity.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

using genetic::Analysis;
using genetic::Library;
using genetic::Quantity;
using Json = nlohmann::json;

constexpr double kFinest = 0.75;  // of a model's spacing: a level that it still has
constexpr int kFewest = 48;       // samples a side that tell what land is like

Json json_of(const Analysis& analysis) {
    Json all = Json::array();
    for (const genetic::Statistics& s : analysis)
        all.push_back({s.count, s.mean, s.deviation, s.skewness, s.kurtosis});
    return all;
}

// Nothing for what is damaged.
std::optional<Analysis> kept(const fs::path& file) {
    std::error_code none;
    if (!fs::exists(file, none)) return {};
    try {
        const Json all = Json::parse(read_text(file));
        Analysis analysis;
        for (std::size_t q = 0; q < analysis.size(); ++q) {
            const Json& s = all.at(q);
            analysis[q] = {s.at(0).get<std::size_t>(), s.at(1).get<double>(),
                           s.at(2).get<double>(), s.at(3).get<double>(),
                           s.at(4).get<double>()};
        }
        return analysis;
    } catch (const Json::exception&) {
        return {};
    }
}

// Analyses of elevation models, made once.
class Analyst {
  public:
    Analyst(fs::path folder, Console& console)
        : folder_(std::move(folder)), console_(console) {
        make_folder(folder_);
    }

    // None where the model is too coarse or too small for the level.
    std::optional<Analysis> operator()(const genetic::Example& example, double level) {
        const fs::path file = folder_ / fmt::format("{:016x}.json", key(example, level));
        if (auto analysis = kept(file)) return usable(*analysis);
        const Terrain& model = model_of(example.source);
        Analysis analysis{};  // empty: kept too
        if (level >= kFinest * model.spacing) {
            const Terrain land = genetic::at_level(part_of(model, example.window), level);
            if (std::min(land.heights.width(), land.heights.height()) >= kFewest)
                analysis = genetic::analysis_of(land);
        }
        write_text(file, json_of(analysis).dump());
        return usable(analysis);
    }

  private:
    static std::uint64_t key(const genetic::Example& example, double level) {
        const auto& w = example.window;
        return hash_text(fmt::format("analysis {} {:016x} {} {} {} {} {}",
                                     genetic::kAnalysisVersion, example.source.hash, w[0],
                                     w[1], w[2], w[3], level));
    }
    static std::optional<Analysis> usable(const Analysis& analysis) {
        if (analysis[0].count == 0) return {};
        return analysis;
    }
    static Terrain part_of(const Terrain& model, const std::array<double, 4>& window) {
        const int w = model.heights.width(), h = model.heights.height();
        // At least one sample.
        const auto begin = [](double share, int n) {
            return std::min(int(share * n), n - 1);
        };
        const auto end = [](double share, int n) {
            return std::max(1, int(share * n + 0.5));
        };
        const int x0 = begin(window[0], w), x1 = std::max(x0 + 1, end(window[2], w)),
                  y0 = begin(1.0 - window[3], h),
                  y1 = std::max(y0 + 1, end(1.0 - window[1], h));
        Terrain part;
        part.spacing = model.spacing;
        part.heights = Field<float>(x1 - x0, y1 - y0);
        for (int y = y0; y < y1; ++y)
            std::copy_n(model.heights.row(y).begin() + x0, x1 - x0,
                        part.heights.row(y - y0).begin());
        return part;
    }
    const Terrain& model_of(const Source& source) {
        if (!model_ || hash_ != source.hash) {
            console_.step("analysing " + source.name());
            model_ = read_dem(source), hash_ = source.hash;
        }
        return *model_;
    }

    fs::path folder_;
    Console& console_;
    std::optional<Terrain> model_;  // the last one
    std::uint64_t hash_ = 0;
};

// A library at one level of detail; types that have no example there are left out.
struct Level {
    double spacing;
    Library library;
};

std::vector<Level> levels_of(const genetic::LibraryOptions& options, Analyst& analyst,
                             Console& console) {
    // Level by level of one model, so that it is read once.
    std::vector<std::vector<genetic::Type>> types(options.levels.size());
    double done = 0.0, all = 0.0;
    for (const auto& type : options.types) all += double(type.examples.size());
    for (const auto& type : options.types) {
        for (auto& level : types) level.push_back({type.name, {}});
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
                      [](const genetic::Type& type) { return type.examples.empty(); });
        if (!types[l].empty()) levels.push_back({options.levels[l], Library(types[l])});
    }
    for (const auto& type : options.types)
        if (std::ranges::none_of(levels, [&](const Level& level) {
                return std::ranges::any_of(
                    level.library.types(),
                    [&](const genetic::Type& t) { return t.name == type.name; });
            }))
            console.warn(fmt::format(
                "'{}' has no example that is fine and large enough at any level",
                type.name));
    if (levels.empty())
        throw bad_request(
            "{}: no example is fine and large enough at any level ({} samples a side)",
            options.name, kFewest);
    return levels;
}

std::size_t width_of(const Library& library) {
    std::size_t width = 8;
    for (const genetic::Type& type : library.types())
        width = std::max(width, type.name.size());
    return width;
}

// A number under each quantity's name.
void print_row(const Library& library, std::size_t type,
               const std::function<double(Quantity)>& value) {
    fmt::print("  {:{}}", library.types()[type].name, width_of(library));
    for (int q = 0; q < genetic::kQuantities; ++q)
        fmt::print("  {:>{}.2f}", value(Quantity(q)),
                   genetic::kQuantityNames[std::size_t(q)].size());
}

void print_head(const Level& level, std::string_view last) {
    fmt::print("{:g} m\n  {:{}}", level.spacing, "", width_of(level.library));
    for (const std::string_view name : genetic::kQuantityNames)
        fmt::print("  {:>{}}", name, name.size());
    fmt::print("  {}\n", last);
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
            request.land.string(), kFewest);
    return all;
}

}  // namespace

void analyse_library(const LibraryRequest& request, Console& console) {
    run(request, console, [&](const auto& options, Analyst& analyst) {
        const std::vector<Level> levels = levels_of(options, analyst, console);
        console.finish();
        for (const Level& level : levels) {
            const Library& library = level.library;
            plot(request, level, "library");
            print_head(level, "examples  own    other");
            for (std::size_t t = 0; t < library.types().size(); ++t) {
                const genetic::Type& type = library.types()[t];
                double own = 1.0, other = 0.0;
                for (const Analysis& example : type.examples)
                    for (std::size_t u = 0; u < library.types().size(); ++u) {
                        const double like = library.similarity(u, example);
                        if (u == t)
                            own = std::min(own, like);
                        else
                            other = std::max(other, like);
                    }
                print_row(library, t,
                          [&](Quantity q) { return library.agreement(t, q); });
                fmt::print("  {:>8}  {:.2f}  {:>5.2f}\n", type.examples.size(), own,
                           other);
            }
        }
        fmt::print(
            "Of each quantity how far a type's examples agree; how like their own type "
            "they "
            "are at least, and how like another at most. All from 0 to 1.\n");
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
            print_head(level, "all");
            for (std::size_t t = 0; t < library.types().size(); ++t) {
                print_row(library, t, [&](Quantity q) {
                    return library.likeness(t, q, land).similarity;
                });
                fmt::print("  {:.2f}\n", library.similarity(t, land));
            }
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
            for (int q = 0; q < genetic::kQuantities; ++q)
                fmt::print("  {:13}  agreement {:.2f}, with it {:.2f}\n",
                           genetic::kQuantityNames[std::size_t(q)],
                           library.agreement(best, Quantity(q)),
                           more.agreement(best, Quantity(q)));
        }
    });
}

}  // namespace cydonia
