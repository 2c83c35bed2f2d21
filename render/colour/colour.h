#pragma once

#include <memory>
#include <string>

#include "field/field.h"
#include "field/image.h"
#include "field/primaries.h"
#include "render/options.h"

namespace cydonia::render {

// The luminance of an ACEScg value relative to white (the Y of AP1).
float luminance(const Rgb& acescg);

// Converts ACEScg to one view of one display of an OCIO config.
class Display {
  public:
    // The config is `options.config`, or else $OCIO, or else the shipped one. Display and
    // view default to those of the config. Throws bad_request, naming the file, when the
    // config is missing, broken or has no colour space for ACEScg, and, listing what
    // there is, when it has no such display or view.
    explicit Display(const ColourOptions& options);
    ~Display();
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    const std::string& display() const { return display_; }
    const std::string& view() const { return view_; }

    Rgb shown(const Rgb& acescg) const;  // a display shows 0 to 1
    Field<Rgb8> shown(Field<Rgb> acescg) const;

  private:
    struct Transform;
    std::string display_, view_;
    std::unique_ptr<Transform> transform_;
};

}  // namespace cydonia::render
