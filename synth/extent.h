#pragma once

namespace cydonia {

// The samples of a terrain.
struct Extent {
    int columns = 0, rows = 0;
    double spacing = 1.0;  // metres

    double width() const { return spacing * columns; }
    double depth() const { return spacing * rows; }
};

}  // namespace cydonia
