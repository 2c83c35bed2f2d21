#include "synth/pareidolia/constrained/records.h"

#include <algorithm>

namespace cydonia::pareidolia {

void RecordsProjection::add_leaf(Kink leaf) {
    leaves_.push_back(leaf);
    std::push_heap(leaves_.begin(), leaves_.end());
}

RecordsProjection::Kink RecordsProjection::pop() {
    Kink kink;
    if (leaves_.empty() || (!lits_.empty() && leaves_.front() < lits_.back())) {
        kink = lits_.back();
        lits_.pop_back();
    } else {
        std::pop_heap(leaves_.begin(), leaves_.end());
        kink = leaves_.back();
        leaves_.pop_back();
    }
    return kink;
}

float RecordsProjection::root() {
    const auto above = [&](const Kink& k) { return slope_ * k.at + constant_ > 0.0; };
    while ((!lits_.empty() && above(lits_.back())) ||
           (!leaves_.empty() && above(leaves_.front()))) {
        const Kink kink = pop();
        slope_ += kink.slope;
        constant_ -= static_cast<double>(kink.slope) * kink.at;
    }
    return static_cast<float>(-constant_ / slope_);
}

// Where the next lit sample lies above the best height of this one, this one stays at its
// best: the derivative above its root is dropped.
void RecordsProjection::next_lit() {
    const float level = root();
    levels_.push_back(level);
    lits_.push_back({level, static_cast<float>(slope_)});
    slope_ = constant_ = 0.0;
}

void RecordsProjection::operator()(const Records& records, int row, int first, int past,
                                   float* heights) {
    const Part* parts = records.parts.row(row).data();
    const float* offsets = records.offsets.row(row).data();
    const float* depths = records.depths.row(row).data();
    lits_.clear();
    leaves_.clear();
    levels_.clear();
    slope_ = constant_ = 0.0;

    int waiting = first;  // for a lit sample: the first that no lit one has followed
    bool any = false;
    for (int i = first; i < past; ++i) {
        const float value = heights[i] + offsets[i];
        if (parts[i] == Part::kShadow) {
            const float floor = value + depths[i];
            add_leaf({value, 1.0f});
            add_leaf({floor, -1.0f});
            slope_ += 1.0;
            constant_ -= floor;
        } else if (parts[i] == Part::kLit) {
            if (any) next_lit();
            any = true;
            for (; waiting < i; ++waiting)
                if (parts[waiting] == Part::kFree)
                    add_leaf({heights[waiting] + offsets[waiting], 1.0f});
            waiting = i + 1;
            slope_ += 1.0;
            constant_ -= value;
        }
    }
    if (!any) return;
    levels_.push_back(root());
    for (std::size_t i = levels_.size() - 1; i > 0; --i)
        levels_[i - 1] = std::min(levels_[i - 1], levels_[i]);

    std::size_t next = 0;
    for (int i = first; i < past; ++i) {
        if (parts[i] == Part::kLit) {
            heights[i] = levels_[next++] - offsets[i];
        } else if (parts[i] == Part::kShadow) {
            const float top = levels_[next - 1] - offsets[i];
            heights[i] = std::clamp(heights[i], top - depths[i], top);
        } else if (parts[i] == Part::kFree) {
            heights[i] = std::min(heights[i], levels_[next] - offsets[i]);
        }
    }
}

}  // namespace cydonia::pareidolia
