#include "config/reader/scene.h"
#include "field/error.h"
namespace cydonia::config {
struct Scene::Document {};
Scene Scene::load(const std::filesystem::path&, const std::vector<std::string>&) {
    throw failure("not built yet");
}
Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
SceneSpec Scene::at(double) const { throw failure("not built yet"); }
Scene::Scene(std::unique_ptr<Document> d) : document_(std::move(d)) {}
}  // namespace cydonia::config
