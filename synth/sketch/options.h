#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "field/length.h"
#include "field/source.h"
#include "synth/geometry/options.h"

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

// A silhouette drawn over a frame, in a drawing that says where its camera stood
// (field/svg_camera.h); section 3.1.
struct View {
    Source drawing;
    std::string id;
    bool mouse = false;
    // Landforms before this one that the stroke threads behind (section 3.4).
    std::vector<std::string> through = {};
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
    // The shadow; several paths of a drawing are its branches. With a view it may be
    // empty: straight between the stroke's ends as they are cast on the land.
    Way way;
    double height = 0.0;   // where no hold says otherwise
    bool relative = true;  // to the land that is there
    // How far from the way the landform ends, left and right; without it as far as the
    // shoulders of a silhouette in a view are long, else half as far as a slope of 30
    // degrees would reach (docs/papers.md, Gain 2009, 2).
    std::optional<std::array<Length, 2>> boundary = {};
    std::optional<Way> boundary_curve = {};  // instead, drawn around the way
    std::vector<Hold> holds = {};
    std::optional<Silhouette> silhouette = {};  // added to these heights
    std::optional<View> view = {};              // instead of them
};

// A part of the land that is as rough as a stroke (section 3.3); its form stays.
struct Region {
    std::string name;
    Way way;  // the loop, closed where it is not
    Silhouette noise;
    Length length = of_width(0.2);  // of the stroke
};

// What the noise of landforms is: without a direction, as the paper's; or as real land's,
// of texture synthesis or of detail by example (section 6, what is still to do).
enum class NoiseKind { kWavelet, kTexture, kDetail };

// Gain, Marais and Strasser, "Terrain Sketching", 2009.
struct Options {
    std::vector<Feature> features;  // each on the land that those before have made
    std::vector<Region> regions;    // after them
    int levels = 6;                 // m: the widest scale is 2^m samples
    NoiseKind noise = NoiseKind::kWavelet;
    // Real land: whose bands are as strong as wavelets are to be, or whose land the noise
    // is.
    std::optional<Source> noise_from = {};
};

}  // namespace cydonia::sketch
