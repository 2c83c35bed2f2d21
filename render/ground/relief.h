#pragma once

#include "field/terrain.h"

namespace cydonia::render {

// The form of the land at a sample, which decides what covers it. Lengths are in metres,
// so that they hold for any number of samples, and at least one cell.
struct Form {
    float height = 0.0f;  // metres
    float slope = 0.0f;   // radians; one third measured over 15 m, two thirds over 45 m
    float north = 0.0f;   // the sine of the slope, towards the north; -1 to 1
    float hollow = 0.0f;  // metres below the mean of the land within 120 m
    float cavity = 0.0f;  // -1 on a sharp edge to 1 in a gully, over 30 m
    float wet = 0.0f;     // ln(a / tan slope), a the drained area per metre of contour
    // Nearness of water, 1 in it and 0 from 50 m on, and the level of that water, metres.
    float shore = 0.0f, level = 0.0f;
};

struct Relief {
    Field<Form> forms;
    double lowest = 0.0, range = 0.0;  // of the dry land, metres
    bool water = false;
};

// Wetness follows Beven and Kirkby 1979, with the flow directions of Freeman 1991. It
// takes the most time and stays 0 unless `wetness` is set.
Relief relief_of(const Terrain& terrain, bool wetness);

}  // namespace cydonia::render
