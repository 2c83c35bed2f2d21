#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/console.h"
#include "field/terrain.h"
#include "synth/genetic/options.h"
#include "synth/statistics/analysis.h"

namespace cydonia {

inline constexpr int kFewestSamples = 48;  // a side, that tell what land is like

// An elevation model, or its window, at a level of detail: what of it is land, and what
// is left out of analyses.
struct Studied {
    Terrain terrain;
    // 1 or empty; voids with 30 of the model's samples about them, whose heights are
    // guesses (Saunders 2006, section VI.2.2).
    Field<std::uint8_t> voids;
    Field<std::uint8_t> water;
    Field<std::uint8_t> inside() const;  // neither; empty: all
};

// Analyses of elevation models, made once and kept in a folder.
class Analyst {
  public:
    Analyst(std::filesystem::path folder, Console& console);

    // None where the model is too coarse or too small for the level, or too little of it
    // is land. What is left out is said, once for each example.
    std::optional<statistics::Analysis> operator()(const genetic::Example& example,
                                                   double level);
    // Of windows spread over it; none where there is no analysis.
    std::vector<statistics::Analysis> windows(const genetic::Example& example,
                                              double level);
    // None where the model is too coarse or too small.
    std::optional<Studied> studied(const genetic::Example& example, double level);

  private:
    struct Model;
    const Model& model_of(const Source& source);
    std::filesystem::path file_of(const char* what, const genetic::Example& example,
                                  double level) const;
    void say_left_out(const genetic::Example& example, double voids, double water,
                      bool too_much);

    std::filesystem::path folder_;
    Console& console_;
    std::shared_ptr<Model> model_;  // the last one
    std::set<std::string> said_;
};

}  // namespace cydonia
