#pragma once

#include "field/field.h"
#include "field/sun.h"
#include "synth/pareidolia/constrained/light_rows.h"
#include "synth/pareidolia/constrained/records.h"

namespace cydonia::pareidolia {

// What one sun must see in each cell of the finished land.
struct Demand {
    Sun sun;
    Field<Part> parts;
    Field<float> edge;  // cells to the nearest one that is not in shadow
    Field<float>
        light;  // margin of lit ground: it rises by this share of the light's fall
    Field<float> crisp;  // margin of shadow beside its edge: the same share
    double depth = 1.0;  // how far below the light shadow may lie; 1: what hides it well
};

// The inequalities of a demand along light rows. Each cell of the grid is `cells` of the
// demand's cells and `spacing` metres wide.
Records records_of(const Demand& demand, const LightRows& rows, double cells,
                   double spacing);

}  // namespace cydonia::pareidolia
