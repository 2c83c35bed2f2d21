#pragma once

#include <string_view>

namespace cydonia {

// Receives the progress of long steps. app/ owns the only one.
class Progress {
  public:
    virtual ~Progress() = default;
    // A new step begins: "text: casting shadows".
    virtual void step(std::string_view name) = 0;
    // The share of the step that is done, 0 to 1. May be called often and by any thread.
    // Throws Interrupted after Ctrl-C.
    virtual void report(double fraction) = 0;
    // A measure of the step's result so far, such as "fitness 0.71", which is shown
    // beside its progress.
    virtual void figure(std::string_view) {}
    // A sentence for the user, such as what was resampled or chosen.
    virtual void note(std::string_view sentence) = 0;
    virtual void warn(std::string_view sentence) = 0;
};

// Thrown after the user pressed Ctrl-C. It unwinds to main(), which cleans up and ends
// the program by that signal.
struct Interrupted {};

// Ignores everything; for tests.
class SilentProgress final : public Progress {
  public:
    void step(std::string_view) override {}
    void report(double) override {}
    void note(std::string_view) override {}
    void warn(std::string_view) override {}
};

}  // namespace cydonia
