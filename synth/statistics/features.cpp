#include "synth/statistics/features.h"

#include <algorithm>
#include <cmath>

#include "synth/statistics/scale_space.h"

namespace cydonia::statistics {
namespace {

constexpr std::size_t kShortest = 5;  // samples; fewer are noise
constexpr float kJump = 1.5f;  // in scale between neighbours, steps of the scale space

}  // namespace

std::vector<Feature> linked(const Found& found, double spacing) {
    const int w = found.place.width(), h = found.place.height();
    std::vector<Feature> features;
    std::vector<std::uint32_t> samples;
    std::vector<bool> seen(found.place.size());
    for (std::size_t start = 0; start < found.place.size(); ++start) {
        if (found.place[start] < 0.0f || seen[start]) continue;
        samples.assign(1, std::uint32_t(start));
        seen[start] = true;
        double scale = 0.0, strength = 0.0;
        for (std::size_t next = 0; next < samples.size(); ++next) {
            const int i = int(samples[next]) % w, j = int(samples[next]) / w;
            const float place = found.place(i, j);
            scale += deviation_at(place), strength += found.response(i, j);
            for (int q = std::max(0, j - 1); q <= std::min(h - 1, j + 1); ++q)
                for (int p = std::max(0, i - 1); p <= std::min(w - 1, i + 1); ++p) {
                    const std::size_t to = found.place.index(p, q);
                    if (seen[to] || found.place[to] < 0.0f ||
                        std::abs(found.place[to] - place) > kJump)
                        continue;
                    seen[to] = true;
                    samples.push_back(std::uint32_t(to));
                }
        }
        if (samples.size() < kShortest) continue;
        const double n = double(samples.size());
        features.push_back({float(scale / n * spacing), float(n * spacing),
                            float(strength / n), samples});
    }
    return features;
}

}  // namespace cydonia::statistics
