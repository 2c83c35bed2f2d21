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
constexpr const char* kApart = ".cache/steps";

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

// A missing or damaged file holds none.
std::map<std::string, Entry> entries_in(const fs::path& file) try {
    std::error_code none;
    if (!fs::exists(file, none)) return {};
    const Json steps = Json::parse(read_text(file));
    std::map<std::string, Entry> entries;
    for (const auto& [step, entry] : steps.items()) entries[step] = entry_of(entry);
    return entries;
} catch (const std::exception&) {
    return {};
}

}  // namespace

Ledger::Ledger(const fs::path& folder)
    : folder_(folder), entries_(entries_in(folder / kFile)) {
    std::error_code none;
    for (const auto& file : fs::directory_iterator(folder_ / kApart, none))
        if (file.path().extension() == ".json") apart_.push_back(file.path());
    // Of a step that several made, the last counts.
    std::ranges::sort(apart_, {}, [](const fs::path& file) {
        return std::pair(time_written(file), file);
    });
    for (const fs::path& file : apart_)
        for (auto& [step, entry] : entries_in(file)) entries_[step] = std::move(entry);
}

void Ledger::record_apart(const std::string& name) {
    make_folder(folder_ / kApart);
    own_file_ = folder_ / kApart / (name + ".json");
    for (const auto& [step, entry] : entries_in(own_file_)) own_.insert(step);
}

void Ledger::write() const {
    Json steps = Json::object();
    for (const auto& [name, entry] : entries_)
        if (own_file_.empty() || own_.contains(name)) steps[name] = json_of(entry);
    write_text(own_file_.empty() ? folder_ / kFile : own_file_, steps.dump(1) + "\n");
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

    if (!own_file_.empty()) own_.insert(step);
    write();
    if (own_file_.empty()) {
        std::error_code none;
        for (const fs::path& file : apart_) fs::remove(file, none);
        apart_.clear();
    }
    return kept;
}

std::string hex(std::uint64_t key) { return fmt::format("{:016x}", key); }

}  // namespace cydonia
