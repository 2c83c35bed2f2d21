#include "synth/texture/geometry.h"

namespace cydonia::texture {

struct Geometry::Parts {
    std::vector<Site> sites;
    std::vector<std::string> names;
};

Geometry::Geometry(const Options&, const Ground&, const HeightAt&, Progress&)
    : parts_(std::make_unique<Parts>()) {}
Geometry::~Geometry() = default;
bool Geometry::empty() const { return true; }
Field<Pull> Geometry::pulls(const Window& window) const {
    return {window.width, window.height};
}
const std::vector<Geometry::Site>& Geometry::sites() const { return parts_->sites; }
const std::vector<std::string>& Geometry::names() const { return parts_->names; }

}  // namespace cydonia::texture
