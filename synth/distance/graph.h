#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "synth/distance/options.h"

namespace cydonia::distance {

// Rusnell 2009, section 3.3, step 1: the costs of a graph's edges.
struct EdgeOptions {
    double mean = 2.0;       // mu_w, metres of cost per metre
    double deviation = 1.0;  // r, 0 <= r < mean
    double grain = 40.0;     // shortest wavelength of the random part, metres
    Options::Metric metric = Options::Metric::kEuclidean;
    int neighbours = 8;  // 8, or 16 (kEuclidean only)
    int octaves = 3;     // of the random part, each twice as long as the one before
    // Values that vary over the land. `weights` replaces all of eq. 3.3 (section 4.3.2).
    std::optional<Map> mean_map{}, deviation_map{}, weights{};
};

// The edge options of a stage whose terrain is `width` metres wide.
EdgeOptions edges_of(const Options& options, double width);

// The 8- or 16-connected grid of a height field's samples. A margin of nodes that no path
// enters surrounds the grid, so that the hot loop needs no bounds check.
struct Graph {
    int width = 0;   // samples, without the margin
    int height = 0;  //
    double spacing = 1.0;
    int directions = 8;
    int margin = 1;
    int stride = 0;  // from a node to the one south of it
    // From a node to its neighbour in each direction; direction d + directions / 2 is
    // opposite to d.
    std::array<int, 16> step{};
    struct Offset {
        int x = 0, y = 0;  // cells east and south
    };
    std::array<Offset, 16> offset{};
    // The cost of each edge in metres, stored at its northern (or western) node:
    // directions / 2 for each node.
    std::vector<float> weights;

    int node(int x, int y) const { return (y + margin) * stride + x + margin; }
    int x_of(int node) const { return node % stride - margin; }
    int y_of(int node) const { return node / stride - margin; }
    int nodes() const { return stride * (height + 2 * margin); }

    float edge(int node, int direction) const {
        const int half = directions / 2;
        if (direction >= half) {
            node += step[direction];
            direction -= half;
        }
        return weights[static_cast<std::size_t>(node) * half + direction];
    }
};

// The least edge weight; 1 when the graph has a single node.
float least_edge(const Graph& graph);

// Makes a graph with edge weights by eq. 3.3, w = mean + deviation * v, times the edge's
// length. v is uniform in [-1, 1]. It is a band-limited function of the position in
// metres, averaged along the edge, so that another number of samples over the same ground
// gives the same land. Throws bad_request unless 0 <= deviation < mean, grain > 0 and
// neighbours is 8 or 16.
Graph graph_of(int width, int height, double spacing, const EdgeOptions& options,
               std::uint64_t seed);

// Makes a graph over the same ground by the same rules, but with nodes a quarter of the
// grain apart (64 to 1024 along the longer side), so that paths on it are the same for
// every number of samples.
Graph layout_graph(const Graph& graph, const EdgeOptions& options, std::uint64_t seed);

}  // namespace cydonia::distance
