#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "field/length.h"
#include "field/source.h"
#include "synth/geometry/options.h"

namespace cydonia::sketch {

// A skyline seen from the side: the paths of a drawing from left to right. A part that is
// drawn later replaces what it retraces. The page reaches from `bottom` to `top` metres.
struct Silhouette {
    Source drawing;
    std::string id;  // of a path or a group of paths; empty: all
    double bottom = 0.0, top = 1000.0;
    bool mouse = false;  // drawn with a mouse: its finest bands are not noise
};

// A silhouette drawn over a frame, in a drawing that contains the camera of the frame
// (field/svg_camera.h); section 3.1.
struct View {
    Source drawing;
    std::string id;
    bool mouse = false;
    // Earlier landforms behind which the stroke passes (section 3.4).
    std::vector<std::string> through = {};
};

// The course of a curve, given as in a texture stage: by points that it passes through
// smoothly, by every path of a drawing whose page lies over the terrain, or by the path
// with `id`.
struct Way {
    std::vector<geometry::Place2> points = {};
    std::optional<Source> drawing = {};
    std::string id = {};
};

// Values of a landform at one position of its way. Values that are not given are
// interpolated.
struct Hold {
    double at = 0.0;  // position as a share of the way's length
    std::optional<double> height = {};
    std::optional<std::array<Length, 2>> boundary = {};  // left and right
};

// A landform (sections 3.1 and 3.2): a ridge where it is higher than the land, a canyon
// where it is lower. Heights are in metres.
struct Feature {
    std::string name;
    // The shadow; several paths of a drawing are its branches. With a view it may be
    // empty, and is then the straight line between the stroke's ends as they are cast on
    // the land.
    Way way;
    double height = 0.0;   // where no hold gives one
    bool relative = true;  // to the land so far
    // The distance from the way at which the landform ends, left and right. If it is not
    // given, it is the length of the shoulders of a silhouette in a view, or else half of
    // what a slope of 30 degrees would need (docs/papers.md, Gain 2009, 2).
    std::optional<std::array<Length, 2>> boundary = {};
    std::optional<Way> boundary_curve =
        {};  // drawn around the way, instead of `boundary`
    std::vector<Hold> holds = {};
    std::optional<Silhouette> silhouette = {};  // added to these heights
    std::optional<View> view = {};              // gives the heights instead
};

// A part of the land that gets the roughness of a stroke (section 3.3) and keeps its
// form.
struct RoughRegion {
    std::string name;
    Way way;  // its outline, which is closed if it is open
    Silhouette noise;
    Length length = of_width(0.2);  // of the stroke
};

// The noise of landforms: without a direction, as in the paper, or that of real land by
// texture synthesis or by detail by example (which section 6 leaves as future work).
enum class NoiseKind { kWavelet, kTexture, kDetail };

// Gain, Marais and Strasser, "Terrain Sketching", 2009.
struct Options {
    std::vector<Feature> features;     // each on the land that those before it made
    std::vector<RoughRegion> regions;  // after the features
    int levels = 6;                    // m: the widest scale is 2^m samples
    NoiseKind noise = NoiseKind::kWavelet;
    // Real land. With wavelets it gives the strength of their bands, otherwise the noise
    // itself.
    std::optional<Source> noise_from = {};
};

}  // namespace cydonia::sketch
