#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace cydonia::test {

// A folder of its own for one test, gone afterwards.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const {
        return path_ / name;
    }

    std::filesystem::path write(const std::string& name, const std::string& text) const;
    // A program for the search path: a shell script.
    std::filesystem::path write_script(const std::string& name,
                                       const std::string& body) const;

  private:
    std::filesystem::path path_;
};

struct Outcome {
    int code = -1;   // exit code; -1 when a signal ended it
    int signal = 0;  // 0 when it ended by itself
    std::string out, err;
};

struct Start {
    std::filesystem::path folder = {};                    // to run in
    std::map<std::string, std::string> environment = {};  // added to ours
    std::size_t max_memory = 0;  // address space, bytes; 0: no limit
};

// The program that was built, run as a user runs it.
Outcome run(const Start& start, const std::vector<std::string>& arguments);

// The same, sent `signal` as soon as `when` holds.
Outcome run_and_signal(const Start& start, const std::vector<std::string>& arguments,
                       int signal, const std::function<bool()>& when);

// Every file below a folder, relative and sorted.
std::vector<std::string> files_below(const std::filesystem::path& folder);
// Those that only half-done work leaves.
std::vector<std::string> temporary_files(const std::filesystem::path& folder);

}  // namespace cydonia::test
