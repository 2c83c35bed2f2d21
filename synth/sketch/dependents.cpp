#include "synth/sketch/dependents.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "field/files.h"

namespace cydonia::sketch {
namespace {

constexpr std::string_view kHead = "cydonia sketch 1";
constexpr std::size_t kLargest = std::size_t{4} << 20;

using Graph = std::map<std::string, std::vector<std::string>>;

// A line for each landform: its name and the names of those it stands on, separated by
// tabs.
Graph remembered(const std::filesystem::path& file) {
    std::error_code none;
    if (file.empty() || !std::filesystem::exists(file, none)) return {};
    std::istringstream lines(read_text(file, kLargest));
    std::string line, name;
    if (!std::getline(lines, line) || line != kHead) return {};
    Graph graph;
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::getline(words, name, '\t');
        auto& below = graph[name];
        while (std::getline(words, name, '\t')) below.push_back(name);
    }
    return graph;
}

// Everything that stood on a landform, directly or not.
void collect(const Graph& graph, const std::string& name, std::vector<std::string>& all) {
    for (const auto& [above, below] : graph)
        if (std::ranges::find(below, name) != below.end() &&
            std::ranges::find(all, above) == all.end()) {
            all.push_back(above);
            collect(graph, above, all);
        }
}

}  // namespace

Stack::Stack(const Field<float>& land, const std::vector<Feature>& features)
    : features_(features),
      top_(land.width(), land.height()),
      stands_on_(features.size()) {
    for (const Feature& feature : features)
        if (feature.view)
            std::ranges::copy(feature.view->through, std::back_inserter(seen_through_));
}

void Stack::add(std::size_t number, const std::vector<std::vector<Foot>>& feet,
                const Field<float>& before) {
    const std::string& name = features_[number].name;
    std::vector<bool> below(features_.size());
    for (const auto& of_one : feet)
        for (const Foot& foot : of_one)
            if (const int top = top_[foot.index]; top > 0 && top <= int(number))
                below[std::size_t(top - 1)] = true;
    for (std::size_t i = 0; i < number; ++i)
        if (below[i]) stands_on_[number].push_back(features_[i].name);
    const bool traced = std::ranges::find(seen_through_, name) != seen_through_.end();
    for (const auto& of_one : feet)
        for (const Foot& foot : of_one) {
            top_[foot.index] = std::uint16_t(number + 1);
            if (!traced) continue;
            traces_[name].samples.push_back(foot.index);
            traces_[name].before.push_back(before[foot.index]);
        }
}

const std::string& Stack::on_top(std::size_t sample) const {
    static const std::string nothing;
    return top_[sample] == 0 ? nothing : features_[top_[sample] - 1u].name;
}

Field<float> Stack::without(const Field<float>& land,
                            const std::vector<std::string>& names) const {
    Field<float> seen = land;
    // The latest first, in the order in which they lie on one another.
    for (auto feature = features_.rbegin(); feature != features_.rend(); ++feature) {
        const auto trace = traces_.find(feature->name);
        if (trace == traces_.end() ||
            std::ranges::find(names, feature->name) == names.end())
            continue;
        for (std::size_t i = 0; i < trace->second.samples.size(); ++i)
            seen[trace->second.samples[i]] = trace->second.before[i];
    }
    return seen;
}

void Stack::compare(const Memory& memory, Progress& progress) const {
    const Graph last = remembered(memory.last);
    std::string text(kHead);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < features_.size(); ++i) {
        names.push_back(features_[i].name);
        text += "\n" + features_[i].name;
        for (const std::string& below : stands_on_[i]) text += "\t" + below;
    }
    const auto is_here = [&](const std::string& name) {
        return std::ranges::find(names, name) != names.end();
    };
    for (const auto& [name, below] : last) {
        if (is_here(name)) continue;
        std::vector<std::string> above;
        collect(last, name, above);
        std::erase_if(above, [&](const std::string& a) { return !is_here(a); });
        if (!above.empty())
            progress.note(fmt::format(
                "'{}' is gone: what stood on it is made again on the land that is left "
                "('{}')",
                name, fmt::join(above, "', '")));
    }
    write_text(memory.next, text + "\n");
}

}  // namespace cydonia::sketch
