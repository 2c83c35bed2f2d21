#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"
#include "synth/pareidolia/light_frame.h"

namespace cydonia::pareidolia {

// How closely the rows follow the mesh.
enum class Stops {
    kColumns,   // one sample a column
    kEveryEdge  // one wherever the light crosses an edge of the mesh (split NW-SE)
};

// The terrain along the direction of light. There is a row for every line of the grid
// along the axis nearest to the light. The samples of a row lie on edges of the mesh, so
// that a sample's height is exactly a mean of the two heights beside it. Under a sun
// along an axis the samples are the heights themselves.
class LightRows {
  public:
    // The rows over width x height heights under a sun at `azimuth` (radians).
    LightRows(int width, int height, double azimuth, Stops stops);

    int rows() const { return static_cast<int>(spans_.size()); }
    int samples() const { return columns_ * stops_; }  // in a row
    double step() const { return step_; }              // cells from a column to the next

    // The samples of a row that lie on the grid: [first, past).
    struct Span {
        int first, past;
    };
    Span span(int row) const { return spans_[static_cast<std::size_t>(row)]; }

    // The position of a sample along its row, in columns.
    double column(int sample) const {
        const int whole = sample / stops_;
        return whole + static_cast<double>(stop(sample).column);
    }
    // False for samples that repeat the one before, where the row crosses fewer edges.
    bool counts(int sample) const { return stop(sample).counts; }
    GridPoint position(double column, int row) const;

    // A h: the heights at every sample, samples() x rows(); 0 beyond the ends of a row
    // and where no sample counts.
    Field<float> sampled(const Field<float>& heights) const;
    // A^T s of samples that are 0 there as well, scaled so that no eigenvalue of A^T A is
    // above 1.
    Field<float> gathered(const Field<float>& at_samples) const;

  private:
    // A point on the edge between two heights, one in column 0 and one in column
    // `columns` after it.
    struct Stop {
        int line, next_line;  // of row 0
        std::int8_t columns;
        float past;    // 0 to 1 of the way to the second height
        float column;  // 0 to 1 of the way to the next column
        bool counts = true;
    };
    std::vector<Stop> crossings(int column) const;
    const Stop& stop(int sample) const {
        return places_[static_cast<std::size_t>(sample)];
    }

    // Turns the grid so that light travels along its rows, and back.
    Field<float> turned(const Field<float>& heights) const;
    Field<float> turned_back(Field<float> along) const;

    bool along_y_, backwards_;  // light travels along y; and against the axis
    int columns_, lines_, stops_;
    double slope_, origin_;  // lines a column; of the first row in the first column
    double step_;
    float share_;  // of what acts on a sample that its heights feel
    std::vector<Stop> places_;
    std::vector<Span> spans_;
};

}  // namespace cydonia::pareidolia
