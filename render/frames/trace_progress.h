#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace cydonia::render {

// How far POV-Ray is with a .pov, as a share of the time that it takes. With radiosity
// POV-Ray goes over the frame five times and more: it gathers light on ever finer grids
// (the pretrace), counting to 100 % over all of them, then traces the pixels, counting
// from 0 again. How long each of these passes takes is estimated from those before it.
class TraceProgress {
  public:
    // `pov`: the text of the scene, which says whether and how light is gathered.
    explicit TraceProgress(std::string_view pov);

    // A line that POV-Ray printed, so many seconds after its start. False where it tells
    // no progress.
    bool hear(std::string_view line, double seconds);

    // 0 to 1; never falls.
    double fraction() const { return fraction_; }

  private:
    struct Pass {
        double expected;     // its share of the time, over that of the whole pretrace
        double from, to;     // of POV-Ray's count
        double begun = 0.0;  // seconds
        struct Report {
            double share, seconds;
        };
        std::vector<Report> reports;
    };
    // Which of 32 strips of the frame, in the order in which POV-Ray works, take time.
    using Strips = std::vector<double>;

    void set_image(std::string_view line);
    void go_to(std::size_t pass, double seconds);
    static Strips strips_of(const Pass& pass, double ended);
    double left(double share, double seconds) const;

    bool has_radiosity_ = false;
    double pretrace_end_ = 0.04;  // of the frame's width: the finest grid
    double pixel_cost_ = 0.0;     // of tracing, over that of gathering at one point
    std::vector<Pass> passes_;
    std::size_t current_ = 0;
    Strips strips_;       // of the pass before; empty: not known
    double counted_ = 0;  // of the count, at last
    double fraction_ = 0.0;
};

}  // namespace cydonia::render
