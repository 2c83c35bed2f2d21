#include "synth/texture/database/neighbourhood.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "synth/texture/database/appearance.h"

namespace cydonia::texture {
namespace {

constexpr int kNumbers = 4 * kCompared.size();
using Numbers = Eigen::Matrix<double, kNumbers, 1>;

// Rounded, so that the last bits of a library's functions do not decide between cells.
float rounded(double value) {
    return static_cast<float>(std::round(value * 4096.0) / 4096.0);
}

Numbers numbers_of(const View& view) {
    Numbers numbers;
    double height = 0.0;
    for (std::size_t k = 0; k < kCompared.size(); ++k) {
        for (int m = 0; m < 4; ++m) numbers[Eigen::Index(4 * k) + m] = view[k][m];
        height += view[k][0] / kComparedCells;
    }
    for (Eigen::Index k = 0; k < kNumbers; k += 4) numbers[k] -= height;
    return numbers;
}

}  // namespace

View wanted_view(const LevelArrays& level, int exemplar, int x, int y, int orientation) {
    const Sheet& sheet = level.sheets[std::size_t(exemplar)];
    const int back = (orientation & 4) ? orientation : (4 - orientation) & 3;
    const Float4 height = {float(level.appearance[sheet.index(x, y)][0]), 0, 0, 0};
    View view;
    for (std::size_t k = 0; k < kCompared.size(); ++k) {
        const Step s = turned(back, kCompared[k]);
        const Appearance& there = level.appearance[sheet.index(x + s.x, y + s.y)];
        view[k] = floats_of(turned_appearance(there, back, level.last_sign)) - height;
    }
    return view;
}

TraitSpace::TraitSpace(const LevelArrays& level) {
    constexpr std::size_t kEnough = 20000;
    std::size_t cells = 0, cell = 0;
    for (const Sheet& sheet : level.sheets) cells += sheet.cells();
    const std::size_t every = 1 + cells / kEnough;
    Eigen::Matrix<double, kNumbers, kNumbers> sum;
    sum.setZero();
    for (int e = 0; e < static_cast<int>(level.sheets.size()); ++e) {
        const Sheet& sheet = level.sheets[std::size_t(e)];
        for (int y = 0; y < sheet.height; ++y)
            for (int x = 0; x < sheet.width; ++x) {
                if (cell++ % every != 0) continue;
                const Numbers numbers = numbers_of(wanted_view(level, e, x, y, 0));
                sum += numbers * numbers.transpose();
            }
    }
    const Eigen::SelfAdjointEigenSolver<decltype(sum)> solver(sum);
    for (int k = 0; k < kNumbers; ++k)
        for (int t = 0; t < kTraits; ++t)
            axes_[k / 4][k % 4][t / 4][t % 4] =
                rounded(solver.eigenvectors()(k, kNumbers - 1 - t));
}

Traits TraitSpace::traits_of(const View& view) const {
    Float4 sums[kTraits / 4] = {};
    for (std::size_t k = 0; k < kCompared.size(); ++k)
        for (int m = 0; m < 4; ++m)
            for (int part = 0; part < kTraits / 4; ++part)
                sums[part] += view[k][m] * axes_[k][m][part];
    Traits traits;
    std::memcpy(traits.data(), sums, sizeof sums);
    return traits;
}

}  // namespace cydonia::texture
