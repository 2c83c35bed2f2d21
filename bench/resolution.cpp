// How far a scene's land at 256 and 1024 samples is from that at 512: RMS difference of
// block means (64 blocks along the longer side), as a share of the relief. The rule is
// 5%.
//
//   cmake --preset bench && cmake --build --preset bench
//   build/bench/bench/resolution scenes/*/scene.toml
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/pipeline/land_store.h"
#include "config/reader/scene.h"
#include "field/error.h"

using namespace cydonia;

namespace {

Terrain land_at(const char* scene, int samples) {
    const auto spec = std::make_shared<const config::SceneSpec>(
        config::Scene::load(scene, {fmt::format("terrain.samples={}", samples)}).at(0));
    SilentProgress progress;
    const auto cache = std::filesystem::temp_directory_path() / "cydonia_resolution";
    std::filesystem::create_directories(cache);
    Terrain land = *LandStore(spec, render::Quality::kDraft, cache, progress).finished();
    std::filesystem::remove_all(cache);
    return land;
}

Field<float> block_means(const Field<float>& field, int blocks) {
    const int side = std::max(field.width(), field.height()) / blocks;
    Field<float> means(field.width() / side, field.height() / side);
    for (int y = 0; y < means.height() * side; ++y)
        for (int x = 0; x < means.width() * side; ++x)
            means(x / side, y / side) += field(x, y) / static_cast<float>(side * side);
    return means;
}

double difference(const Field<float>& a, const Field<float>& b) {
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) squares += (a[i] - b[i]) * (a[i] - b[i]);
    const auto [low, high] = std::ranges::minmax(a);
    return std::sqrt(squares / static_cast<double>(a.size())) / (high - low);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        fmt::print("{:>8} {:>8} {:>8}  scene\n", "256", "1024", "limit");
        for (int i = 1; i < argc; ++i) {
            constexpr int kBlocks = 64;
            const auto low_pass = [&](int samples) {
                return block_means(land_at(argv[i], samples).heights, kBlocks);
            };
            const Field<float> reference = low_pass(512);
            fmt::print("{:7.2f}% {:7.2f}% {:>8}  {}\n",
                       100.0 * difference(reference, low_pass(256)),
                       100.0 * difference(reference, low_pass(1024)), "5%", argv[i]);
        }
        return 0;
    } catch (const Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return static_cast<int>(error.code());
    }
}
