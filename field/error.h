#pragma once

#include <fmt/core.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace cydonia {

// What the process returns to its caller.
enum class ExitCode { kDone = 0, kFailed = 1, kBadRequest = 2, kCheckFellShort = 3 };

// The one exception of the program: its message is one a user can act on.
class Error : public std::runtime_error {
  public:
    Error(ExitCode code, const std::string& message)
        : std::runtime_error(message), code_(code) {}
    ExitCode code() const { return code_; }

  private:
    ExitCode code_;
};

// The request itself is wrong: a scene file, an input image, an option.
template <class... Args>
Error bad_request(fmt::format_string<Args...> format, Args&&... args) {
    return Error(ExitCode::kBadRequest, fmt::format(format, std::forward<Args>(args)...));
}

// The request is right and could not be carried out: a full disk, no POV-Ray.
template <class... Args>
Error failure(fmt::format_string<Args...> format, Args&&... args) {
    return Error(ExitCode::kFailed, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace cydonia
