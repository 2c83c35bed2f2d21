#include "app/pipeline/ledger.h"

#include <fmt/core.h>

#include <algorithm>
#include <system_error>

#include "field/error.h"
#include "field/files.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

constexpr const char* kFile = ".cache/steps.json";

Json json_of(const Entry& entry) {
    return {{"key", entry.key},         {"outputs", entry.outputs},
            {"sizes", entry.sizes},     {"result", entry.result},
            {"seconds", entry.seconds}, {"peak_memory", entry.peak_memory}};
}

Entry entry_of(const Json& json) {
    return {json.at("key"),    json.at("outputs"), json.at("sizes"),
            json.at("result"), json.at("seconds"), json.at("peak_memory")};
}

// Outputs are plain names below the folder; anything else is not ours to touch.
bool inside(const fs::path& relative) {
    return relative.is_relative() && std::ranges::find(relative, "..") == relative.end();
}

bool has_size(const fs::path& file, std::uint64_t size) {
    std::error_code none;
    return fs::is_regular_file(file, none) && fs::file_size(file, none) == size;
}

bool intact(const fs::path& folder, const Entry& entry) {
    if (entry.outputs.size() != entry.sizes.size()) return false;
    for (std::size_t i = 0; i < entry.outputs.size(); ++i) {
        if (!has_size(folder / entry.outputs[i], entry.sizes[i])) return false;
    }
    return true;
}

}  // namespace

Ledger::Ledger(const fs::path& output_folder) : folder_(output_folder) {
    if (std::error_code none; !fs::exists(folder_ / kFile, none)) return;
    try {
        const Json steps = Json::parse(read_text(folder_ / kFile));
        for (const auto& [name, entry] : steps.items()) entries_[name] = entry_of(entry);
    } catch (const std::exception&) {
        entries_.clear();
    }
}

const Entry* Ledger::finished(const std::string& step, std::uint64_t key) const {
    const std::scoped_lock lock(*mutex_);
    const auto found = entries_.find(step);
    if (found == entries_.end() || found->second.key != key) return nullptr;
    return intact(folder_, found->second) ? &found->second : nullptr;
}

std::vector<std::string> Ledger::outputs_of(const std::string& step) const {
    const std::scoped_lock lock(*mutex_);
    const auto found = entries_.find(step);
    return found == entries_.end() ? std::vector<std::string>{} : found->second.outputs;
}

const Entry& Ledger::record(const std::string& step, Entry entry) {
    const std::scoped_lock lock(*mutex_);
    entry.sizes.clear();
    for (const std::string& output : entry.outputs) {
        entry.sizes.push_back(fs::file_size(folder_ / output));
    }
    for (const std::string& old : entries_[step].outputs) {
        std::error_code none;
        if (inside(old) && std::ranges::find(entry.outputs, old) == entry.outputs.end()) {
            fs::remove(folder_ / old, none);
        }
    }
    Entry& kept = entries_[step];
    kept = std::move(entry);

    Json steps = Json::object();
    for (const auto& [name, e] : entries_) steps[name] = json_of(e);
    write_text(folder_ / kFile, steps.dump(1) + "\n");
    return kept;
}

std::string hex(std::uint64_t key) { return fmt::format("{:016x}", key); }

}  // namespace cydonia
