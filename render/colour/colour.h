#pragma once

#include <memory>
#include <string>

#include "field/field.h"
#include "field/image.h"
#include "field/primaries.h"
#include "render/options.h"

namespace cydonia::render {

// What light an ACEScg value stands for, relative to white (the Y of AP1).
float luminance(const Rgb& acescg);

// ACEScg as one view of one display of an OCIO config shows it.
class Display {
  public:
    // The config is `options.config`, else $OCIO, else the shipped one; display and view
    // are its defaults unless named. Throws bad_request, naming the file, when it is
    // missing or broken or has no colour space for ACEScg, and when it has no such
    // display or view: the message lists what there is.
    explicit Display(const ColourOptions& options);
    ~Display();
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    const std::string& display() const { return display_; }
    const std::string& view() const { return view_; }

    Rgb shown(const Rgb& acescg) const;  // 0 to 1 is what a display can show
    Field<Rgb8> shown(Field<Rgb> acescg) const;

  private:
    struct Transform;
    std::string display_, view_;
    std::unique_ptr<Transform> transform_;
};

}  // namespace cydonia::render
