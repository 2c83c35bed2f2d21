#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "field/length.h"
#include "field/source.h"
#include "synth/texture/options.h"

namespace cydonia::sketch {

// A stroke seen from the side, drawn from left to right: paths of a drawing, of which
// what is drawn later replaces what it retraces. The page is `bottom` to `top` metres
// high.
struct Silhouette {
    Source drawing;
    std::string id;  // of the path, or of a group of them; empty: all
    double bottom = 0.0, top = 1000.0;
    bool mouse = false;  // drawn with a mouse, whose finest bands are no noise
};

// Where a curve runs, as a texture stage's: points that it passes through smoothly, or
// every path of a drawing whose page lies over the terrain, or the one with `id`.
struct Way {
    std::vector<texture::Place2> points = {};
    std::optional<Source> drawing = {};
    std::string id = {};
};

// What a landform is at one place of its way; what is not given is interpolated.
struct Hold {
    double at = 0.0;  // share of the way
    std::optional<double> height = {};
    std::optional<std::array<Length, 2>> boundary = {};  // left and right
};

// A landform (sections 3.1 and 3.2): a ridge where it is higher than the land, a canyon
// where it is lower. Heights in metres.
struct Feature {
    std::string name;
    Way way;               // the shadow
    double height = 0.0;   // where no hold says otherwise
    bool relative = true;  // to the land that is there
    // How far from the way the landform ends, left and right; without it half as far as a
    // slope of 30 degrees would reach (notes.md, Gain 2009, 2).
    std::optional<std::array<Length, 2>> boundary = {};
    std::vector<Hold> holds = {};
    std::optional<Silhouette> silhouette = {};  // added to these heights
};

// A part of the land that is as rough as a stroke (section 3.3); its form stays.
struct Region {
    std::string name;
    Way way;  // the loop, closed where it is not
    Silhouette noise;
    Length length = of_width(0.2);  // of the stroke
};

// Gain, Marais and Strasser, "Terrain Sketching", 2009.
struct Options {
    std::vector<Feature> features;  // each on the land that those before have made
    std::vector<Region> regions;    // after them
    int levels = 6;                 // m: the widest scale is 2^m samples
};

}  // namespace cydonia::sketch
