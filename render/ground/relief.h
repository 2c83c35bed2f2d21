#pragma once

#include "field/terrain.h"

namespace cydonia::render {

// What the land's form says of a sample, for what lies on it. Lengths are of metres, so
// that they hold for any number of samples, but never less than a cell.
struct Form {
    float height = 0.0f;  // metres
    float slope = 0.0f;   // radians; a third at 15 m, two at 45 m
    float north = 0.0f;   // the sine of the slope, towards the north; -1 to 1
    float hollow = 0.0f;  // metres below the land around, at 120 m
    float cavity = 0.0f;  // -1 on a sharp edge to 1 in a gully, at 30 m
    float wet = 0.0f;  // ln(a / tan slope), a the metres of land drained through a metre
    // How near water is: 1 in it, 0 from 50 m on; and its level there, metres.
    float shore = 0.0f, level = 0.0f;
};

struct Relief {
    Field<Form> forms;
    double lowest = 0.0, range = 0.0;  // of the dry land, metres
    bool water = false;
};

// Wetness after Beven and Kirkby 1979, drained by Freeman's many directions (1991); it
// costs most and stays 0 unless asked for.
Relief relief_of(const Terrain& terrain, bool wetness);

}  // namespace cydonia::render
