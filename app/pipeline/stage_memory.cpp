#include "app/pipeline/stage_memory.h"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <functional>
#include <string_view>
#include <system_error>
#include <utility>

#include "field/files.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

constexpr std::string_view kPrefix = "stage-";
constexpr const char* kRuns =
    ".runs";  // holds the keys of the last run and the one before

void remove_where(const fs::path& folder,
                  const std::function<bool(const std::string& name)>& goes) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none))
        if (goes(entry.path().filename().string())) fs::remove(entry, none);
}

}  // namespace

StageMemory::StageMemory(fs::path folder, int stage, const std::string& method)
    : folder_(std::move(folder)),
      prefix_(fmt::format("{}{}.", kPrefix, stage)),
      name_(prefix_ + method),
      one_file_(true),
      files_{folder_ / name_, folder_ / name_} {}

StageMemory::StageMemory(fs::path folder, int stage, const std::string& method,
                         std::uint64_t key)
    : StageMemory(std::move(folder), stage, method) {
    one_file_ = false;
    key_ = key;
    std::ifstream(folder_ / (name_ + kRuns)) >> std::hex >> last_ >> before_;
    files_ = {file_of(key_ == last_ ? before_ : last_), file_of(key_)};
}

fs::path StageMemory::file_of(std::uint64_t key) const {
    return key == 0 ? fs::path() : folder_ / fmt::format("{}.{:016x}", name_, key);
}

void StageMemory::end_run() {
    if (!one_file_ && key_ != last_) {
        write_text(folder_ / (name_ + kRuns), fmt::format("{:x} {:x}\n", key_, last_));
        before_ = std::exchange(last_, key_);
    }
    remove_where(folder_, [&](const std::string& name) {
        if (!name.starts_with(prefix_) || name == name_ || name == name_ + kRuns)
            return false;
        const fs::path file = folder_ / name;
        return one_file_ ? !name.starts_with(name_ + ".")
                         : file != file_of(last_) && file != file_of(before_);
    });
}

void forget_stages_after(const fs::path& folder, int stages) {
    remove_where(folder, [&](const std::string& name) {
        if (!name.starts_with(kPrefix)) return false;
        int stage = 0;
        const std::string_view number = std::string_view(name).substr(kPrefix.size());
        std::from_chars(number.data(), number.data() + number.size(), stage);
        return stage > stages;
    });
}

}  // namespace cydonia
