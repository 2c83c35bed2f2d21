#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"

namespace cydonia::pareidolia {

// What a sample of a light row must be. With g = height + rise along the light, lit
// samples are running maxima of g. Samples in shadow stay below the last of them, and
// samples that may be either stay below the next one, so that they take light from
// nothing.
enum class Part : std::uint8_t { kAny, kLit, kShadow, kFree };

// The inequalities of one sun. A sample's height plus its `offset` (the light's rise, and
// margins) must be: not below the lit sample before it (kLit); not above the lit sample
// before it, and not more than `depth` below it (kShadow); not above the next lit sample
// (kFree). Every sample in shadow has a lit sample before it, and every free one has a
// lit one after it.
struct Records {
    Field<Part> parts;
    Field<float> offsets;  // metres
    Field<float> depths;   // metres
};

// Finds the nearest heights, in the least squares, that obey the inequalities along one
// row: an isotonic regression on a chain of lit samples with the others as leaves. It is
// exact and takes O(n log n): the derivative of the least cost so far is carried along
// the row as a sum of kinks. There is one object for each thread, because it keeps its
// memory.
class RecordsProjection {
  public:
    // Changes the samples [first, past) of row `row` in place.
    void operator()(const Records& records, int row, int first, int past, float* heights);

  private:
    // A kink: the derivative is steeper by `slope` below `at`.
    struct Kink {
        float at, slope;
        bool operator<(const Kink& other) const { return at < other.at; }
    };
    void add_leaf(Kink leaf);
    Kink pop();       // the greatest
    float root();     // where the derivative is zero; kinks above are taken up
    void next_lit();  // the derivative of the best with this lit sample below the next

    double slope_ = 0.0, constant_ = 0.0;  // of the derivative above the greatest kink
    std::vector<Kink> lits_;               // of lit samples, ascending
    std::vector<Kink> leaves_;             // a heap, greatest first
    std::vector<float> levels_;            // of the lit samples
};

}  // namespace cydonia::pareidolia
