#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cydonia::render {

// A program that runs without a shell, in a process group of its own: Ctrl-C reaches only
// this process, which then ends it. The program dies when this process does.
class Child {
  public:
    // Throws failure() when no process can be created. A program that cannot be started
    // ends with the exit code kCannotStart.
    Child(const std::filesystem::path& program, const std::vector<std::string>& arguments,
          const std::filesystem::path& folder);
    ~Child();  // kills the program and all that it started, and waits for it
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    // Waits up to `patience` and appends what the program printed to `output`. Returns
    // false once the program has ended and all of its output has been read.
    bool read(std::string& output, std::chrono::milliseconds patience);

    // The exit code of the program that ended, or minus the signal that killed it.
    int outcome() const { return outcome_; }

    static constexpr int kCannotStart = 127;

  private:
    bool has_ended();
    void read_what_is_there(std::string& output);

    pid_t process_ = -1;
    int output_ = -1;  // its standard output and error; never blocks
    bool all_read_ = false;
    bool ended_ = false;
    int outcome_ = 0;
};

// Runs a program to its end and returns Child::outcome(), or nothing when the program was
// killed because `time_limit` had passed. Calls `listen` at least ten times a second, and
// once more at the end with a new line appended. `output` holds what the program has
// printed; `listen` may remove what it has read. An exception from `listen` kills the
// program.
std::optional<int> outcome_of(const std::filesystem::path& program,
                              const std::vector<std::string>& arguments,
                              const std::filesystem::path& folder,
                              std::chrono::seconds time_limit,
                              const std::function<void(std::string& output)>& listen);

// Removes all whole lines from `output` and passes each to `take`. A line ends with a new
// line or a carriage return. An unfinished line of more than 64 KiB is dropped.
void take_lines(std::string& output, const std::function<void(std::string_view)>& take);

}  // namespace cydonia::render
