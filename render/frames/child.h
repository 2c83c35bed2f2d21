#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <string>
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

}  // namespace cydonia::render
