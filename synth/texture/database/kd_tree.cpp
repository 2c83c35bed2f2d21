#include "synth/texture/database/kd_tree.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <tuple>

namespace cydonia::texture {
namespace {

// The axis along which samples differ most, estimated from some of them.
int widest_axis(std::span<const Sample> samples) {
    const std::size_t every = std::max<std::size_t>(1, samples.size() / 64);
    Traits sum{}, squares{};
    float count = 0.0f;
    for (std::size_t i = 0; i < samples.size(); i += every, count += 1.0f)
        for (std::size_t k = 0; k < kTraits; ++k) {
            sum[k] += samples[i].traits[k];
            squares[k] += samples[i].traits[k] * samples[i].traits[k];
        }
    for (std::size_t k = 0; k < kTraits; ++k) squares[k] -= sum[k] * sum[k] / count;
    return static_cast<int>(std::ranges::max_element(squares) - squares.begin());
}

}  // namespace

KdTree::KdTree(std::vector<Sample> samples) : samples_(std::move(samples)) {
    while ((samples_.size() >> depth_) > kLeaf) ++depth_;
    nodes_.resize((std::size_t{1} << depth_) - 1);
    grow(0, samples_);
}

void KdTree::grow(std::size_t node, std::span<Sample> samples) {
    if (node >= nodes_.size()) return;
    const int axis = widest_axis(samples);
    const std::size_t half = samples.size() / 2;
    // Samples with equal traits are ordered by position, so that the halves are always
    // the same.
    std::nth_element(
        samples.begin(), samples.begin() + std::ptrdiff_t(half), samples.end(),
        [axis](const Sample& a, const Sample& b) {
            const float u = a.traits[std::size_t(axis)], v = b.traits[std::size_t(axis)];
            if (u != v) return u < v;
            return std::tie(a.exemplar, a.y, a.x) < std::tie(b.exemplar, b.y, b.x);
        });
    nodes_[node] = {axis, samples[half].traits[std::size_t(axis)]};
    const auto lower = [&] { grow(2 * node + 1, samples.first(half)); };
    const auto upper = [&] { grow(2 * node + 2, samples.subspan(half)); };
    if (samples.size() < 4096) {
        lower();
        upper();
    } else {
        tbb::parallel_invoke(lower, upper);
    }
}

std::span<const Sample> KdTree::around(const Traits& traits) const {
    std::size_t node = 0, first = 0, count = samples_.size();
    for (int level = 0; level < depth_; ++level) {
        const Node& at = nodes_[node];
        const bool upper = traits[std::size_t(at.axis)] >= at.split;
        node = 2 * node + (upper ? 2 : 1);
        first += upper ? count / 2 : 0;
        count = upper ? count - count / 2 : count / 2;
    }
    return std::span(samples_).subspan(first, count);
}

}  // namespace cydonia::texture
