#pragma once

#include <optional>
#include <string>

#include "field/camera.h"
#include "field/source.h"

// A drawing over a frame says in its metadata where the frame's camera stood, so that
// strokes stay where they were drawn whatever becomes of the scene's cameras.
namespace cydonia {

// The element for <metadata> that describes a perspective camera.
std::string svg_camera_text(const Camera& camera);

// The camera whose frame is the drawing's page, with the page's proportions; none when
// the drawing names none. Throws bad_request for values that no camera can have.
std::optional<Camera> svg_camera(const Source& source);

}  // namespace cydonia
