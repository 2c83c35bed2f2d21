#pragma once

#include <string>
#include <vector>

#include "config/reader/scene.h"
#include "config/reader/table.h"
#include "field/noise.h"
#include "field/sun.h"

namespace cydonia::config {

// One function for each struct, in the file named beside it: it is the list of the
// struct's fields.

// The methods. A new method needs one line here and one file beside this one; without
// them terrain.cpp does not compile.
void read(Table& t, dem::Options& o);         // dem.cpp
void read(Table& t, detail::Options& o);      // detail.cpp
void read(Table& t, distance::Options& o);    // distance.cpp
void read(Table& t, genetic::Options& o);     // genetic.cpp
void read(Table& t, pareidolia::Options& o);  // pareidolia.cpp
void read(Table& t, sketch::Options& o);      // sketch.cpp
void read(Table& t, texture::Options& o);     // texture.cpp

void read(Table& t, Sun& sun);                         // common.cpp
void read(Table& t, NoiseOptions& noise);              // common.cpp
void read(Table& t, GeographicPosition& place);        // frames.cpp
void read(Table& t, genetic::MapRegion& region);       // genetic.cpp
void read(Table& t, render::CameraKey& key);           // render_cameras.cpp
void read(Table& t, render::ThingOptions& thing);      // render_things.cpp
void read(Table& t, render::CameraOptions& camera);    // render_cameras.cpp
void read(Table& t, render::FineReliefOptions& fine);  // render.cpp
void read(Table& t, render::SkyOptions& sky);          // render.cpp
void read(Table& t, render::HazeOptions& haze);        // render.cpp
void read(Table& t, render::PassOptions& passes);      // render.cpp

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

// The unit of the elevation of a sun that casts shadows: above the horizon and not
// overhead.
struct SunElevation {
    static constexpr bool kVaries = true;
    double read(const Value& value, Files& files) const;
    std::string text(double radians) const { return Degrees{}.text(radians); }
    std::string schema() const;
};
// Azimuths may exceed a turn in both directions, so that a sun can pass through north
// from 350 to 370.
constexpr Degrees kAzimuth{from(-360.0, 720.0)};

// Checks 0 <= r < mu_w, because Dijkstra's algorithm needs edges of positive cost.
void check_edge_weights(Table& t, double mean, double deviation);  // common.cpp

}  // namespace cydonia::config
