#pragma once

#include <string>
#include <vector>

#include "config/reader/scene.h"
#include "config/reader/table.h"
#include "field/noise.h"
#include "field/sun.h"

namespace cydonia::config {

// One function a struct, in the file of its group: each is the list of the struct's
// fields. A new method is one such file and one line in terrain.cpp.

void read(Table& t, Sun& sun);                         // common.cpp
void read(Table& t, Place& place);                     // frames.cpp
void read(Table& t, NoiseOptions& noise);              // common.cpp
void read(Table& t, render::CameraKey& key);           // render_cameras.cpp
void read(Table& t, render::ThingOptions& thing);      // render_things.cpp
void read(Table& t, render::CameraOptions& camera);    // render_cameras.cpp
void read(Table& t, render::FineReliefOptions& fine);  // render.cpp
void read(Table& t, render::SkyOptions& sky);          // render.cpp
void read(Table& t, render::HazeOptions& haze);        // render.cpp
void read(Table& t, render::PassOptions& passes);      // render.cpp
void read(Table& t, dem::Options& o);                  // dem.cpp
void read(Table& t, detail::Options& o);               // detail.cpp
void read(Table& t, distance::Options& o);             // distance.cpp
void read(Table& t, genetic::Options& o);              // genetic.cpp
void read(Table& t, genetic::MapRegion& region);       // genetic.cpp
void read(Table& t, pareidolia::Options& o);           // pareidolia.cpp
void read(Table& t, sketch::Options& o);               // sketch.cpp
void read(Table& t, texture::Options& o);              // texture.cpp

struct TerrainTable {
    TerrainSpec& terrain;
    std::vector<StageSpec>& stages;
};
void read(Table& t, TerrainTable& out);  // terrain.cpp

struct RenderTable {
    render::Options& options;
    std::string& text;
};
void read(Table& t, RenderTable& out);  // render.cpp

struct FramesTable {
    FramesSpec& frames;
    std::string& text;
};
void read(Table& t, FramesTable& out,
          const std::vector<render::CameraOptions>& cameras);  // frames.cpp

// A sun that casts shadows: above the horizon and not overhead.
struct SunElevation {
    static constexpr bool kVaries = true;
    double read(const Value& value, Files& files) const;
    std::string text(double radians) const { return Degrees{}.text(radians); }
    std::string schema() const;
};
// One turn either way, so that a sun may pass through north: 350 to 370.
constexpr Degrees kAzimuth{from(-360.0, 720.0)};

// 0 <= r < mu_w: an edge that costs nothing or less would let Dijkstra run in circles.
void check_edge_weights(Table& t, double mean, double deviation);  // common.cpp

}  // namespace cydonia::config
