#pragma once

#include <cstdlib>
#include <optional>
#include <string>

namespace cydonia {

// An environment variable for the length of one test; nullptr: not set.
class Environment {
  public:
    Environment(const char* name, const char* value) : name_(name) {
        if (const char* before = std::getenv(name)) before_ = before;
        assign(value);
    }
    ~Environment() { assign(before_ ? before_->c_str() : nullptr); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

  private:
    void assign(const char* value) {
        if (value)
            setenv(name_, value, 1);
        else
            unsetenv(name_);
    }
    const char* name_;
    std::optional<std::string> before_;
};

}  // namespace cydonia
