#pragma once

#include <string_view>

namespace cydonia {

// Where long steps say how far they are. One sink, owned by app/.
class Progress {
  public:
    virtual ~Progress() = default;
    // A new step begins: "text: casting shadows".
    virtual void step(std::string_view name) = 0;
    // 0 to 1 within the step; any thread, often. Throws Interrupted after Ctrl-C.
    virtual void report(double fraction) = 0;
    // How good the step's work is by now, shown beside how far it is: "fitness 0.71".
    virtual void figure(std::string_view) {}
    // A sentence the user should read: what was resampled, what was chosen.
    virtual void note(std::string_view sentence) = 0;
    virtual void warn(std::string_view sentence) = 0;
};

// The user pressed Ctrl-C: unwound to main, which cleans up and ends by that signal.
struct Interrupted {};

// Says nothing: for tests.
class SilentProgress final : public Progress {
  public:
    void step(std::string_view) override {}
    void report(double) override {}
    void note(std::string_view) override {}
    void warn(std::string_view) override {}
};

}  // namespace cydonia
