#pragma once

namespace cydonia::texture {

// A rectangle of the plane's cells at one level of synthesis. Level 0 has the exemplars'
// own cells; a cell of level i covers 2^i by 2^i of them. The north-west corner of cell
// (0, 0) of every level is that of the terrain; x grows to the east and y to the south,
// and both may be negative.
struct Window {
    int level = 0;
    int x = 0, y = 0;
    int width = 0, height = 0;

    bool contains(int cx, int cy) const {
        return cx >= x && cy >= y && cx < x + width && cy < y + height;
    }
    Window grown(int cells) const {
        return {level, x - cells, y - cells, width + 2 * cells, height + 2 * cells};
    }
    // The cells of the next coarser level that touch it.
    Window coarser() const {
        const int x1 = (x + width - 1) >> 1, y1 = (y + height - 1) >> 1;
        return {level + 1, x >> 1, y >> 1, x1 - (x >> 1) + 1, y1 - (y >> 1) + 1};
    }
    bool operator==(const Window&) const = default;
};

}  // namespace cydonia::texture
