#pragma once

#include <optional>
#include <string>

#include "field/error.h"
#include "render/frames/povray.h"

namespace cydonia {

// Why a test that draws with POV-Ray cannot run here; nullopt where it can.
inline std::optional<std::string> no_povray() {
    try {
        render::povray_program();
    } catch (const Error& error) {
        return error.what();
    }
    return std::nullopt;
}

}  // namespace cydonia
