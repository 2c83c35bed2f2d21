#include "config/reader/names.h"

#include <fmt/format.h>

#include <algorithm>

#include "field/data.h"

namespace cydonia::config {
namespace {

Wrong none_such(std::string_view thing, const std::string& name, std::string_view where,
                const std::vector<std::string>& known) {
    return {fmt::format("no {} '{}'{}{}", thing, name, where,
                        known.empty() ? "" : suggestion(name, known))};
}

std::vector<std::string> shipped_profiles() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(data_folder("profiles")))
        if (entry.path().extension() == ".csv")
            names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

}  // namespace

std::string GroupName::read(const Value& value, Files& files) const {
    const std::string name = Word{}.read(value, files);
    if (contains(known, name) || (!other.empty() && name == other)) return name;
    auto names = known;
    if (!other.empty()) names.emplace_back(other);
    throw none_such("group", name, where, names);
}

std::string ProfileName::read(const Value& value, Files& files) const {
    const std::string name = Word{}.read(value, files);
    if (contains(own, name)) return name;
    std::vector<std::string> known = shipped_profiles();
    if (contains(known, name)) return name;
    known.insert(known.begin(), own.begin(), own.end());
    throw none_such("profile", name, "", known);
}

std::filesystem::path shipped_profile(const std::string& name) {
    return data_file(fmt::format("profiles/{}.csv", name));
}

}  // namespace cydonia::config
