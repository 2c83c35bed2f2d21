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
// us, who then end it. It dies with us, however we die.
class Child {
  public:
    // Throws failure() when no process can be made. A program that cannot be started
    // ends with kCannotStart.
    Child(const std::filesystem::path& program, const std::vector<std::string>& arguments,
          const std::filesystem::path& folder);
    ~Child();  // killed, with all that it started, and waited for
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    // Appends what it printed, after at most `patience`; false when it has ended and all
    // is read.
    bool read(std::string& output, std::chrono::milliseconds patience);

    // How it ended: its exit code, or minus the signal that killed it.
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

// Runs a program to its end and gives Child::outcome(). `listen` gets what the program
// printed and nobody took out of it yet, ten times a second at least and once in the end,
// with a new line after all; what it throws kills the program. So does the end of
// `time_limit`: then there is no outcome.
std::optional<int> outcome_of(const std::filesystem::path& program,
                              const std::vector<std::string>& arguments,
                              const std::filesystem::path& folder,
                              std::chrono::seconds time_limit,
                              const std::function<void(std::string& output)>& listen);

// Moves whole lines out of `output`, each ended by a new line or a carriage return, and
// all of it when it is longer than any line should be.
void take_lines(std::string& output, const std::function<void(std::string_view)>& take);

}  // namespace cydonia::render
