#include "app/pipeline/ledger.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>
#include <system_error>

#include "field/error.h"
#include "field/files.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

constexpr const char* kFile = ".cache/steps.jsonl";
constexpr const char* kApart = ".cache/steps";
constexpr std::size_t kFewLines = 64;  // stale lines that are not worth a new file

std::string line_of(const std::string& step, const StepRecord& record) {
    const Json json = {{"step", step},
                       {"key", record.key},
                       {"outputs", record.outputs},
                       {"sizes", record.sizes},
                       {"result", record.result},
                       {"seconds", record.seconds},
                       {"peak_memory", record.peak_memory},
                       {"hashes", record.hashes},
                       {"written", record.written}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

StepRecord record_of(const Json& json) {
    return {json.at("key"),    json.at("outputs"), json.at("sizes"),
            json.at("result"), json.at("seconds"), json.at("peak_memory"),
            json.at("hashes"), json.at("written")};
}

// Outputs are paths below the folder. A damaged ledger may name others: leave them alone.
bool inside(const fs::path& relative) {
    return relative.is_relative() && std::ranges::find(relative, "..") == relative.end();
}

bool has_size(const fs::path& file, std::uint64_t size) {
    std::error_code none;
    return fs::is_regular_file(file, none) && fs::file_size(file, none) == size;
}

// Larger files are known by size and date alone.
std::uint64_t hash_of_output(const fs::path& file, std::uint64_t size) {
    constexpr std::uint64_t kMost = std::uint64_t{1} << 30;
    return size > kMost ? 0 : hash_of_file(file);
}

std::int64_t time_written(const fs::path& file) {
    std::error_code none;
    return fs::last_write_time(file, none).time_since_epoch().count();
}

bool intact(const fs::path& folder, const StepRecord& record) {
    const std::size_t count = record.outputs.size();
    if (record.sizes.size() != count || record.hashes.size() != count ||
        record.written.size() != count)
        return false;
    for (std::size_t i = 0; i < count; ++i) {
        const fs::path file = folder / record.outputs[i];
        if (!has_size(file, record.sizes[i])) return false;
        if (time_written(file) != record.written[i] &&
            hash_of_output(file, record.sizes[i]) != record.hashes[i])
            return false;
    }
    return true;
}

struct Lines {
    std::size_t count = 0;  // complete records
    bool torn = false;      // a line is no record
};

// Reads the records of a file; they replace those of the same steps.
Lines read_lines(const fs::path& file, std::map<std::string, StepRecord>& records) {
    Lines lines;
    std::ifstream in(file, std::ios::binary);
    for (std::string line; std::getline(in, line);) {
        try {
            const Json json = Json::parse(line);
            records[json.at("step").get<std::string>()] = record_of(json);
            ++lines.count;
        } catch (const std::exception&) {
            lines.torn = true;
        }
        if (in.eof()) lines.torn = true;  // without its end: the next would run on
    }
    return lines;
}

void refuse_doubles(const std::string& step, const StepRecord& record) {
    std::set<std::string> files;
    for (const std::string& file : record.outputs)
        if (!files.insert(file).second)
            throw failure("'{}' wrote {} twice: two of its results have the same name",
                          step, file);
}

}  // namespace

Ledger::Ledger(const fs::path& folder) : folder_(folder), file_(folder / kFile) {
    reload();
}

void Ledger::reload() {
    const std::scoped_lock lock(mutex_);
    records_.clear();
    apart_.clear();
    const Lines lines = read_lines(folder_ / kFile, records_);
    is_worn_ = lines.torn || lines.count > 2 * records_.size() + kFewLines;
    std::error_code none;
    for (const auto& file : fs::directory_iterator(folder_ / kApart, none))
        if (file.path().extension() == ".jsonl") apart_.push_back(file.path());
    // If several processes made a step, the last record counts.
    std::ranges::sort(apart_, {}, [](const fs::path& file) {
        return std::pair(time_written(file), file);
    });
    for (const fs::path& file : apart_) read_lines(file, records_);
}

void Ledger::record_apart(const std::string& name) {
    const std::scoped_lock lock(mutex_);
    make_folder(folder_ / kApart);
    file_ = folder_ / kApart / (name + ".jsonl");
    is_apart_ = true;
    std::map<std::string, StepRecord> own;
    is_worn_ = read_lines(file_, own).torn;
    if (!is_worn_) return;
    std::string text;  // without the incomplete line
    for (const auto& [step, record] : own) text += line_of(step, record);
    write_text(file_, text);
    is_worn_ = false;
}

bool Ledger::has(const std::string& step) const {
    const std::scoped_lock lock(mutex_);
    return records_.contains(step);
}

const StepRecord* Ledger::finished(const std::string& step, Key key) const {
    const std::scoped_lock lock(mutex_);
    const auto found = records_.find(step);
    if (found == records_.end() || found->second.key != key) return nullptr;
    return intact(folder_, found->second) ? &found->second : nullptr;
}

std::vector<std::string> Ledger::outputs_of(const std::string& step) const {
    const std::scoped_lock lock(mutex_);
    const auto found = records_.find(step);
    return found == records_.end() ? std::vector<std::string>{} : found->second.outputs;
}

const StepRecord& Ledger::record(const std::string& step, StepRecord record) {
    refuse_doubles(step, record);
    record.sizes.clear();
    record.hashes.clear();
    record.written.clear();
    for (const std::string& output : record.outputs) {
        const fs::path file = folder_ / output;
        record.written.push_back(time_written(file));
        record.sizes.push_back(fs::file_size(file));
        record.hashes.push_back(hash_of_output(file, record.sizes.back()));
    }
    const std::scoped_lock lock(mutex_);
    StepRecord& kept = records_[step];
    const std::set<std::string> now(record.outputs.begin(), record.outputs.end());
    for (const std::string& old : kept.outputs) {
        std::error_code none;
        if (inside(old) && !now.contains(old)) fs::remove(folder_ / old, none);
    }
    kept = std::move(record);
    if (!is_apart_ && (is_worn_ || !apart_.empty()))
        rewrite();
    else
        append(step, kept);
    return kept;
}

void Ledger::append(const std::string& step, const StepRecord& record) {
    if (!is_apart_) make_folder(file_.parent_path());
    std::ofstream out(file_, std::ios::binary | std::ios::app);
    out << line_of(step, record) << std::flush;
    if (out) return;
    is_worn_ = true;  // part of the line may have been written
    throw failure("{}: {}", file_.string(), std::strerror(errno));
}

void Ledger::rewrite() {
    std::string text;
    for (const auto& [step, record] : records_) text += line_of(step, record);
    write_text(file_, text);
    is_worn_ = false;
    std::error_code none;
    for (const fs::path& file : apart_) fs::remove(file, none);
    apart_.clear();
}

}  // namespace cydonia
