#pragma once

#include <array>
#include <limits>
#include <span>

#include "synth/texture/database/neighbourhood.h"

namespace cydonia::texture {

// A match in the same exemplar lies farther than this from its cell, in squared cells.
inline constexpr int kFarEnough = 25;
inline constexpr float kNoMatch = std::numeric_limits<float>::infinity();

// The best match of one cell among the candidates considered so far.
class BestMatch {
  public:
    // Starts with `match`, whose dissimilarity is `score`, and replaces both with
    // anything better. Only orientations among `turns` may be considered.
    BestMatch(const LevelArrays& level, std::span<const int> turns, int of_exemplar,
              int at_x, int at_y, Match& match, float& score)
        : exemplar(of_exemplar),
          x(at_x),
          y(at_y),
          level_(level),
          match_(match),
          score_(score) {
        for (int o : turns)
            wanted_[std::size_t(o)] = wanted_view(level, exemplar, x, y, o);
    }

    const int exemplar, x, y;

    const Match& match() const { return match_; }
    const View& wanted(int orientation) const {
        return wanted_[std::size_t(orientation)];
    }

    // Whether land can be taken from there, and it is far enough from the cell itself.
    bool allowed(int e, int u, int v) const {
        const Sheet& sheet = level_.sheets[std::size_t(e)];
        if (u < 0 || v < 0 || u >= sheet.width || v >= sheet.height) return false;
        const int dx = u - x, dy = v - y;
        if (e == exemplar && dx * dx + dy * dy <= kFarEnough) return false;
        return level_.types[sheet.index(u, v)] != kNowhere;
    }

    void consider(int e, int u, int v, int orientation) {
        if (!allowed(e, u, v)) return;
        const Sheet& sheet = level_.sheets[std::size_t(e)];
        const float score = dissimilarity(
            wanted(orientation), &level_.appearance[sheet.index(u, v)], sheet.stride);
        if (score >= score_) return;
        score_ = score;
        match_ = {static_cast<std::uint16_t>(u), static_cast<std::uint16_t>(v),
                  static_cast<std::uint8_t>(e), static_cast<std::uint8_t>(orientation)};
    }

  private:
    const LevelArrays& level_;
    Match& match_;
    float& score_;
    std::array<View, 8> wanted_;
};

}  // namespace cydonia::texture
