#include "app/pipeline/ledger.h"

#include <fmt/core.h>

#include <algorithm>
#include <system_error>

#include "app/pipeline/cache.h"
#include "field/error.h"
#include "field/files.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

constexpr const char* kFile = ".cache/steps.json";

Json json_of(const Entry& entry) {
    return {{"key", entry.key},         {"outputs", entry.outputs},
            {"sizes", entry.sizes},     {"result", entry.result},
            {"seconds", entry.seconds}, {"peak_memory", entry.peak_memory},
            {"hashes", entry.hashes},   {"written", entry.written}};
}

Entry entry_of(const Json& json) {
    return {json.at("key"),    json.at("outputs"), json.at("sizes"),
            json.at("result"), json.at("seconds"), json.at("peak_memory"),
            json.at("hashes"), json.at("written")};
}

// Outputs are plain names below the folder; anything else is not ours to touch.
bool inside(const fs::path& relative) {
    return relative.is_relative() && std::ranges::find(relative, "..") == relative.end();
}

bool has_size(const fs::path& file, std::uint64_t size) {
    std::error_code none;
    return fs::is_regular_file(file, none) && fs::file_size(file, none) == size;
}

// Larger ones are known by size and date alone.
std::uint64_t hash_of_output(const fs::path& file, std::uint64_t size) {
    constexpr std::uint64_t kMost = std::uint64_t{1} << 30;
    return size > kMost ? 0 : hash_of_file(file);
}

std::int64_t time_written(const fs::path& file) {
    std::error_code none;
    return fs::last_write_time(file, none).time_since_epoch().count();
}

bool intact(const fs::path& folder, const Entry& entry) {
    const std::size_t count = entry.outputs.size();
    if (entry.sizes.size() != count || entry.hashes.size() != count ||
        entry.written.size() != count)
        return false;
    for (std::size_t i = 0; i < count; ++i) {
        const fs::path file = folder / entry.outputs[i];
        if (!has_size(file, entry.sizes[i])) return false;
        if (time_written(file) != entry.written[i] &&
            hash_of_output(file, entry.sizes[i]) != entry.hashes[i])
            return false;
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
    entry.sizes.clear();
    entry.hashes.clear();
    entry.written.clear();
    for (const std::string& output : entry.outputs) {
        const fs::path file = folder_ / output;
        entry.written.push_back(time_written(file));
        entry.sizes.push_back(fs::file_size(file));
        entry.hashes.push_back(hash_of_output(file, entry.sizes.back()));
    }
    const std::scoped_lock lock(*mutex_);
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
