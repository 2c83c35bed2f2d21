// Rusnell 2009, sections 5.3.1 and 5.3.2.
#include "synth/pareidolia/shadow_lines.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <span>

#include "field/sample.h"

namespace cydonia::pareidolia {
namespace {

// The shadow line along one row of the light frame, as heights over a plane that falls
// with the light: level over shadow, rising over holes.
class RowLines {
  public:
    // The heights that the line gains where it enters a hole and with every sample in it.
    RowLines(std::span<const std::uint8_t> depths, double enter, double gain,
             std::span<double> line)
        : depths_(depths), enter_(enter), gain_(gain), line_(line) {}

    // A shadow of depth `level` over the samples [first, past), with its holes filled,
    // that ends at `end`.
    void lay_shadow(int first, int past, int level, double end) {
        double at = end;
        each_deeper(first, past, level,
                    [&](int from, int to) { at -= enter_ + gain_ * (to - from); });
        int shadow = first;
        each_deeper(first, past, level, [&](int from, int to) {
            std::fill(line_.begin() + shadow, line_.begin() + from, at);
            lay_hole(from, to, level + 1, at + enter_);
            at += enter_ + gain_ * (to - from);
            shadow = to;
        });
        std::fill(line_.begin() + shadow, line_.begin() + past, at);
    }

  private:
    // A hole, with its islands filled, whose ground begins at `start`.
    void lay_hole(int first, int past, int level, double start) {
        for (int i = first; i < past; ++i) line_[i] = start + gain_ * (i - first);
        each_deeper(first, past, level, [&](int from, int to) {
            lay_shadow(from, to, level + 1, start + gain_ * (to - first));
        });
    }

    // Calls visit(first, past) for the stretches that are deeper than `level`.
    template <class Visit>
    void each_deeper(int first, int past, int level, const Visit& visit) const {
        for (int i = first; i < past; ++i) {
            if (depths_[i] <= level) continue;
            const int from = i;
            while (i < past && depths_[i] > level) ++i;
            visit(from, i);
        }
    }

    std::span<const std::uint8_t> depths_;
    double enter_, gain_;
    std::span<double> line_;
};

Field<std::uint8_t> depths_of(const RegionTree& tree) {
    Field<std::uint8_t> depths(tree.region_at.width(), tree.region_at.height());
    // Beyond depth 253 only the alternation of shadow and light is kept.
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const int depth = tree.depth_at(i);
        depths[i] = static_cast<std::uint8_t>(depth < 254 ? depth : 254 + depth % 2);
    }
    return depths;
}

// The ground of holes from the rows of light. Neighbouring rows differ by the stairs in
// the outline of cells. They are smoothed because the ground would otherwise be too rough
// to be lit.
class HoleGround {
  public:
    // Adds the value of a row: `level` is the height over a plane that falls as the
    // ground does.
    HoleGround(int width, int height)
        : levels_(cv::Mat::zeros(height, width, CV_64F)),
          counts_(cv::Mat::zeros(height, width, CV_64F)) {}
    void add(Cell c, double level) {
        levels_.at<double>(c.y, c.x) += level;
        counts_.at<double>(c.y, c.x) += 1.0;
    }

    // Averages over a few cells; 0 where there is no hole.
    Field<double> levels() const {
        Field<double> result(levels_.cols, levels_.rows);
        cv::Mat sums, weights;
        cv::GaussianBlur(levels_, sums, {}, kSmooth);
        cv::GaussianBlur(counts_, weights, {}, kSmooth);
        for (int y = 0; y < levels_.rows; ++y)
            for (int x = 0; x < levels_.cols; ++x)
                if (holds(x, y))
                    result(x, y) = sums.at<double>(y, x) / weights.at<double>(y, x);
        return result;
    }
    bool holds(int x, int y) const { return counts_.at<double>(y, x) > 0.0; }

  private:
    static constexpr double kSmooth = 1.5;  // cells

    cv::Mat levels_, counts_;
};

}  // namespace

ShadowLines lines_of_runs(const ShadowPlan& plan, const Field<float>& ground) {
    return {crest_heights(plan, ground), {}};
}

ShadowLines lines_of_regions(const ShadowPlan& plan, const RegionTree& tree,
                             const Field<float>& ground, double above, double fall) {
    const LightFrame& frame = plan.frame;
    const Field<std::uint8_t> depths = rotated(depths_of(tree), frame);
    const double per_sample = plan.rise / frame.density;
    const double gain = (1.0 - fall) * per_sample;
    std::vector<double> line(frame.side);
    ShadowLines result;
    HoleGround holes(plan.width(), plan.height());
    auto run = plan.runs.begin();
    for (int row = 0; row < frame.side; ++row) {
        const auto depth = depths.row(row);
        RowLines lines(depth, above, gain, line);
        for (int i = 0; i < frame.side; ++i) {
            if (depth[i] == 0) continue;
            const int first = i;
            while (i < frame.side && depth[i] > 0) ++i;
            const GridPoint end = frame.position(i - 0.5, row);
            lines.lay_shadow(first, i, 1,
                             bilinear(ground, end.x, end.y) + per_sample * (i - 0.5));
        }
        for (; run != plan.runs.end() && run->row == row; ++run)
            result.crests.push_back(
                static_cast<float>(line[run->first] - per_sample * (run->first - 0.5)));
        for (int i = 0; i < frame.side; ++i) {
            if (depth[i] == 0 || depth[i] % 2 != 0) continue;
            const Cell c = cell_of(frame.position(i, row));
            if (!plan.target->contains(c.x, c.y)) continue;
            holes.add(c, line[i] - gain * i);
        }
    }
    result.holes = Field<float>(plan.width(), plan.height(), kNowhere);
    const Field<double> levels = holes.levels();
    for (int y = 0; y < plan.height(); ++y) {
        for (int x = 0; x < plan.width(); ++x) {
            const double at = frame.sample_at({1.0 * x, 1.0 * y});
            if (holes.holds(x, y))
                result.holes(x, y) =
                    static_cast<float>(levels(x, y) + (gain - per_sample) * at);
        }
    }
    return result;
}

}  // namespace cydonia::pareidolia
