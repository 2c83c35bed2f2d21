#include "synth/detail/filters.h"

#include <algorithm>

namespace cydonia::detail {
namespace {

int finer(Filter filter, int coarse) {
    switch (filter) {
        case Filter::kChaikin:
            return 2 * coarse - 2;
        case Filter::kHaar:
            return 2 * coarse;
        case Filter::kFaber:
        case Filter::kCubic:
            return 2 * coarse - 1;
    }
    return 0;
}

// The shortest line on which the filters of its two ends do not overlap.
int fewest(Filter filter) { return filter == Filter::kChaikin ? 4 : 2; }

// Weights of the same value are added up.
void add(Stencil& stencil, int index, float weight) {
    for (int i = 0; i < stencil.count; ++i)
        if (stencil.taps[std::size_t(i)].index == index) {
            stencil.taps[std::size_t(i)].weight += weight;
            return;
        }
    stencil.taps[std::size_t(stencil.count++)] = {index, weight};
}
Stencil stencil(std::initializer_list<Stencil::Tap> taps) {
    Stencil result;
    for (const Stencil::Tap& tap : taps) add(result, tap.index, tap.weight);
    return result;
}

// Quadratic B-splines whose ends are interpolated (docs/papers.md, Brosz 2007, 1). Inner
// rows are as published; the outer ones follow from A P = 1, B P = 0 and P A + Q B = 1.
FilterBank chaikin(int n) {
    const int fine = 2 * n - 2, last = fine - 1;
    FilterBank bank{fine, n, n - 2, {}, {}, {}};
    bank.a.push_back(stencil({{0, 1.0f}}));
    const auto outer = [](int at, int step, float sign) {
        return stencil({{at, -0.5f},
                        {at + step, 1.0f},
                        {at + 2 * step, sign * 0.75f},
                        {at + 3 * step, -sign * 0.25f}});
    };
    for (int i = 1; i <= n - 2; ++i) {
        if (i == 1) {
            bank.a.push_back(outer(0, 1, 1.0f));
            bank.b.push_back(outer(0, 1, -1.0f));
        } else if (i == n - 2) {
            bank.a.push_back(outer(last, -1, 1.0f));
            bank.b.push_back(outer(last, -1, -1.0f));
        } else {
            const int j = 2 * i - 2;
            bank.a.push_back(
                stencil({{j, -0.25f}, {j + 1, 0.75f}, {j + 2, 0.75f}, {j + 3, -0.25f}}));
            bank.b.push_back(
                stencil({{j, 0.25f}, {j + 1, -0.75f}, {j + 2, 0.75f}, {j + 3, -0.25f}}));
        }
    }
    bank.a.push_back(stencil({{last, 1.0f}}));

    bank.pq.resize(std::size_t(fine));
    const auto p = [&](int j, int i, float weight) {
        add(bank.pq[std::size_t(j)], i, weight);
    };
    const auto q = [&](int j, int i, float weight) {
        add(bank.pq[std::size_t(j)], n + i - 1, weight);
    };
    p(0, 0, 1.0f), p(last, n - 1, 1.0f);
    p(1, 0, 0.5f), p(1, 1, 0.5f);
    p(last - 1, n - 1, 0.5f), p(last - 1, n - 2, 0.5f);
    for (int i = 1; i < n - 2; ++i) {
        p(2 * i, i, 0.75f), p(2 * i, i + 1, 0.25f);
        p(2 * i + 1, i, 0.25f), p(2 * i + 1, i + 1, 0.75f);
    }
    q(1, 1, 0.5f), q(2, 1, -0.75f), q(3, 1, -0.25f);
    q(last - 1, n - 2, 0.5f), q(last - 2, n - 2, -0.75f), q(last - 3, n - 2, -0.25f);
    for (int i = 2; i < n - 2; ++i) {
        const int j = 2 * i - 2;
        q(j, i, -0.25f), q(j + 1, i, -0.75f), q(j + 2, i, 0.75f), q(j + 3, i, 0.25f);
    }
    return bank;
}

FilterBank haar(int n) {
    FilterBank bank{2 * n, n, n, {}, {}, {}};
    for (int i = 0; i < n; ++i) {
        bank.a.push_back(stencil({{2 * i, 0.5f}, {2 * i + 1, 0.5f}}));
        bank.b.push_back(stencil({{2 * i, 0.5f}, {2 * i + 1, -0.5f}}));
        bank.pq.push_back(stencil({{i, 1.0f}, {n + i, 1.0f}}));
        bank.pq.push_back(stencil({{i, 1.0f}, {n + i, -1.0f}}));
    }
    return bank;
}

// Linear interpolation; every second value is kept.
FilterBank faber(int n) {
    FilterBank bank{2 * n - 1, n, n - 1, {}, {}, {}};
    for (int i = 0; i < n; ++i) {
        bank.a.push_back(stencil({{2 * i, 1.0f}}));
        bank.pq.push_back(stencil({{i, 1.0f}}));
        if (i == n - 1) break;
        bank.b.push_back(
            stencil({{2 * i, -0.5f}, {2 * i + 1, 1.0f}, {2 * i + 2, -0.5f}}));
        bank.pq.push_back(stencil({{i, 0.5f}, {i + 1, 0.5f}, {n + i, 1.0f}}));
    }
    return bank;
}

// Adds one stencil, times a factor, to another.
void add(Stencil& stencil, const Stencil& other, float weight) {
    for (int k = 0; k < other.count; ++k)
        add(stencil, other.taps[std::size_t(k)].index,
            weight * other.taps[std::size_t(k)].weight);
}

// Cubic B-splines, mirrored at the ends, by lifting (Bertram, Duchaineau, Hamann and Joy
// 2004). Even values become coarse ones, the difference of odd ones from these are
// details, and details then smooth the coarse values. Away from the ends these are the
// local least-squares filters of Samavati and Bartels.
FilterBank cubic(int n) {
    constexpr float kSmoothing = 23.0f / 49.0f;
    const int fine = 2 * n - 1;
    FilterBank bank{fine, n, n - 1, {}, {}, {}};
    const auto odd = [&](int i) { return i < 0 ? 1 : i >= n - 1 ? fine - 2 : 2 * i + 1; };
    const auto detail = [&](int i) { return std::clamp(i, 0, n - 2); };
    for (int i = 0; i < n; ++i)
        bank.a.push_back(stencil({{2 * i, 2.0f}, {odd(i - 1), -0.5f}, {odd(i), -0.5f}}));
    for (int i = 0; i < n - 1; ++i) {
        Stencil b = stencil({{2 * i + 1, 1.0f}});
        for (const int side : {i, i + 1}) add(b, bank.a[std::size_t(side)], -0.5f);
        bank.b.push_back(b);
    }
    std::vector<Stencil> rough;  // coarse values before they are smoothed
    for (int i = 0; i < n; ++i) {
        rough.push_back(stencil({{i, 1.0f}}));
        for (const int side : {i - 1, i}) {
            add(bank.a[std::size_t(i)], bank.b[std::size_t(detail(side))], kSmoothing);
            add(rough.back(), n + detail(side), -kSmoothing);
        }
    }
    const auto odd_value = [&](int i) {
        Stencil s = stencil({{n + i, 1.0f}});
        add(s, rough[std::size_t(i)], 0.5f), add(s, rough[std::size_t(i + 1)], 0.5f);
        return s;
    };
    for (int i = 0; i < n; ++i) {
        Stencil even;
        add(even, rough[std::size_t(i)], 0.5f);
        for (const int side : {i - 1, i}) add(even, odd_value(detail(side)), 0.25f);
        bank.pq.push_back(even);
        if (i < n - 1) bank.pq.push_back(odd_value(i));
    }
    return bank;
}

}  // namespace

FilterBank filter_bank(Filter filter, int coarse) {
    switch (filter) {
        case Filter::kChaikin:
            return chaikin(coarse);
        case Filter::kHaar:
            return haar(coarse);
        case Filter::kFaber:
            return faber(coarse);
        case Filter::kCubic:
            return cubic(coarse);
    }
    return {};
}

int divisible(Filter filter, int length, int levels) {
    const auto fine_of = [&](int coarse) {
        for (int level = 0; level < levels; ++level) coarse = finer(filter, coarse);
        return coarse;
    };
    int coarse = std::max(fewest(filter), length >> levels);
    while (fine_of(coarse) < length) ++coarse;
    return fine_of(coarse);
}

int coarser(Filter filter, int length) {
    switch (filter) {
        case Filter::kChaikin:
            return (length + 2) / 2;
        case Filter::kHaar:
            return length / 2;
        case Filter::kFaber:
        case Filter::kCubic:
            return (length + 1) / 2;
    }
    return 0;
}

}  // namespace cydonia::detail
