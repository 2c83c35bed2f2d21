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

inline constexpr int kFewestSamples = 48;  // a side; fewer do not characterise land

// An elevation model, or a window of it, at one level of detail, and which of its samples
// are left out of analyses.
struct Studied {
    Terrain terrain;
    // 1 in voids and within 30 of the model's samples of one, where heights are guesses
    // (Saunders 2006, section VI.2.2); may be empty.
    Field<std::uint8_t> voids;
    Field<std::uint8_t> water;
    Field<std::uint8_t> inside() const;  // 1 where neither; empty: everywhere
};

// Makes analyses of elevation models and keeps them in a folder.
class Analyst {
  public:
    Analyst(std::filesystem::path folder, Console& console);

    // None if the model is too coarse or too small for the level, or has too little land.
    // Notes what is left out, once for each example.
    std::optional<statistics::Analysis> operator()(const genetic::Example& example,
                                                   double level);
    // Of windows spread over the model; empty if there is no analysis.
    std::vector<statistics::Analysis> windows(const genetic::Example& example,
                                              double level);
    // None if the model is too coarse or too small.
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
    std::shared_ptr<Model> model_;  // the last one read
    std::set<std::string> said_;
};

}  // namespace cydonia
