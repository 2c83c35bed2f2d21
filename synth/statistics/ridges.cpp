#include "synth/statistics/ridges.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "field/sample.h"

namespace cydonia::statistics {
namespace {

// The least change of slope over a ridge's own width, so that rounding and level land
// make no ridges.
constexpr float kFaintestRidge = 0.01f;

// The responses of one scale. `line` is positive on ridges and negative in valleys;
// `peak` is 0 where the land is not a summit. Both are 0 on the outermost samples.
struct Responses {
    Field<float> line, peak;
};

void respond(const Scale& scale, Responses& out) {
    const Field<float>& land = scale.land;
    const int w = land.width(), h = land.height();
    const float t = float(scale.deviation * scale.deviation),
                weight = float(std::pow(scale.deviation, 1.5));  // t^(3/4)
    parallel_for(std::max(0, h - 2), 16, [&](int inner) {
        const int y = inner + 1;
        const float *n = land.row(y - 1).data(), *m = land.row(y).data(),
                    *s = land.row(y + 1).data();
        float *line = out.line.row(y).data(), *peak = out.peak.row(y).data();
        for (int x = 1; x + 1 < w; ++x) {
            const float xx = m[x + 1] - 2.0f * m[x] + m[x - 1],
                        yy = s[x] - 2.0f * m[x] + n[x],
                        xy = 0.25f * (s[x + 1] - s[x - 1] - n[x + 1] + n[x - 1]);
            const float sum = xx + yy, apart = (xx - yy) * (xx - yy) + 4.0f * xy * xy;
            const float strength = weight * std::sqrt(apart);
            const float both = 0.25f * t * t * (sum * sum - apart);
            line[x] = sum < 0.0f ? strength : -strength;
            peak[x] = sum < 0.0f && both > 0.0f ? both : 0.0f;
        }
    });
}

// Whether the land is highest there (sign 1) or lowest (-1) across the line, that is
// along the direction of the larger principal curvature: Lp = 0 (Lindeberg 1998, section
// 5).
bool is_on_line(const Field<float>& land, float sign, int x, int y) {
    const float m = land(x, y);
    const float xx = land(x + 1, y) - 2.0f * m + land(x - 1, y),
                yy = land(x, y + 1) - 2.0f * m + land(x, y - 1),
                xy = 0.25f * (land(x + 1, y + 1) - land(x - 1, y + 1) -
                              land(x + 1, y - 1) + land(x - 1, y - 1));
    const float apart = std::sqrt((xx - yy) * (xx - yy) + 4.0f * xy * xy);
    const float curvature = 0.5f * (xx + yy - sign * apart);
    if (!(sign * curvature < 0.0f)) return false;
    // That direction, from the row of the matrix that determines it better.
    float px = curvature - yy, py = xy;
    if (std::abs(xx - curvature) > std::abs(yy - curvature)) px = xy, py = curvature - xx;
    const float length = std::sqrt(px * px + py * py);
    if (!(length > 0.0f)) return false;
    // All directions point the same way, so that of two equally high samples exactly one
    // is on the line.
    const double way = (px < 0.0f || (px == 0.0f && py < 0.0f) ? -1.0 : 1.0) / length;
    const double dx = way * px, dy = way * py;
    return sign * m > sign * bilinear(land, x + dx, y + dy) &&
           sign * m >= sign * bilinear(land, x - dx, y - dy);
}

// Peaks of scale `k`: samples with the largest response among their 26 neighbours in the
// plane and over scales.
void find_peaks(const std::array<const Field<float>*, 3>& around, int k, double spacing,
                std::vector<Feature>& peaks) {
    const Field<float>& own = *around[1];
    const double deviation = deviation_at(k);
    const float faintest = float(kFaintestRidge * kFaintestRidge * deviation * deviation);
    std::vector<std::vector<Feature>> rows(std::size_t(own.height()));
    parallel_for(std::max(0, own.height() - 2), 16, [&](int inner) {
        const int y = inner + 1;
        for (int x = 1; x + 1 < own.width(); ++x) {
            const std::size_t i = own.index(x, y);
            const float b = own[i], a = (*around[0])[i], c = (*around[2])[i];
            if (!(b > faintest && b > a && b >= c)) continue;
            bool largest = true;
            for (int z = 0; z < 3 && largest; ++z)
                for (int q = -1; q <= 1; ++q)
                    for (int p = -1; p <= 1; ++p) {
                        const float other = (*around[std::size_t(z)])(x + p, y + q);
                        // Of equal responses the last counts.
                        const int order = 9 * (z - 1) + 3 * q + p;
                        if (order < 0 ? other > b : order > 0 && other >= b)
                            largest = false;
                    }
            if (!largest) continue;
            const float bend = a - 2.0f * b + c;
            const double place = float(k) + (bend < 0.0f ? 0.5f * (a - c) / bend : 0.0f);
            rows[std::size_t(y)].push_back({float(deviation_at(place) * spacing),
                                            0.0f,
                                            std::sqrt(b),
                                            {std::uint32_t(i)}});
        }
    });
    for (const auto& row : rows) peaks.insert(peaks.end(), row.begin(), row.end());
}

}  // namespace

Ridges ridges_of(const std::vector<Scale>& land, double spacing) {
    Ridges result;
    if (land.empty()) return result;
    const int w = land[0].land.width(), h = land[0].land.height();
    Found ridges(w, h), valleys(w, h);
    std::array<Responses, 3> responses;  // of a scale and of its two neighbours
    responses.fill({Field<float>(w, h), Field<float>(w, h)});
    for (int k = 0; k < int(land.size()); ++k) {
        respond(land[std::size_t(k)], responses[std::size_t(k % 3)]);
        if (k < 2) continue;
        const Scale& scale = land[std::size_t(k - 1)];
        const Responses &finer = responses[std::size_t((k - 2) % 3)],
                        &own = responses[std::size_t((k - 1) % 3)],
                        &coarser = responses[std::size_t(k % 3)];
        const auto crest = [&](float sign) {
            return [&, sign](int x, int y) { return is_on_line(scale.land, sign, x, y); };
        };
        const float faintest = kFaintestRidge * float(std::sqrt(scale.deviation));
        find_largest(finer.line, own.line, coarser.line, 1.0f, k - 1, faintest,
                     crest(1.0f), ridges);
        find_largest(finer.line, own.line, coarser.line, -1.0f, k - 1, faintest,
                     crest(-1.0f), valleys);
        find_peaks({&finer.peak, &own.peak, &coarser.peak}, k - 1, spacing, result.peaks);
    }
    result.ridges = linked(ridges, spacing), result.valleys = linked(valleys, spacing);
    return result;
}

Ridges ridges_of(const Field<float>& heights, double spacing) {
    Field<float> slopes = heights;
    for (float& height : slopes) height = float(height / spacing);
    return ridges_of(scale_space(slopes), spacing);
}

}  // namespace cydonia::statistics
