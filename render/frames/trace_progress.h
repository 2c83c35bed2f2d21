#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace cydonia::render {

// Estimates which share of the time for a frame POV-Ray has used. With radiosity POV-Ray
// passes over the frame several times: it gathers light on finer and finer grids (the
// pretrace) while it counts to 100 %, then traces the pixels and counts from 0 again. The
// time of each pass is estimated from the passes before it.
class TraceProgress {
  public:
    // `pov` is the text of the scene: it says whether and how finely light is gathered.
    explicit TraceProgress(std::string_view pov);

    // Takes a line that POV-Ray printed `seconds` after its start. Returns whether the
    // line reports progress.
    bool hear(std::string_view line, double seconds);

    // From 0 to 1; it never decreases.
    double fraction() const { return fraction_; }

  private:
    struct Pass {
        double expected;     // its time, where the whole pretrace takes 1
        double from, to;     // the part of POV-Ray's count that belongs to it
        double begun = 0.0;  // seconds
        struct Report {
            double share, seconds;
        };
        std::vector<Report> reports;
    };
    // The relative time that each of 32 strips of the frame takes, in the order in which
    // POV-Ray traces them.
    using Strips = std::vector<double>;

    void set_image(std::string_view line);
    void go_to(std::size_t pass, double seconds);
    static Strips strips_of(const Pass& pass, double ended);
    double left(double share, double seconds) const;

    bool has_radiosity_ = false;
    double pretrace_end_ = 0.04;  // spacing of the finest grid, over the frame's width
    double pixel_cost_ = 0.0;  // of a traced pixel, where a point of the pretrace costs 1
    std::vector<Pass> passes_;
    std::size_t current_ = 0;
    Strips strips_;       // of the previous pass; empty when unknown
    double counted_ = 0;  // the last count, 0 to 1
    double fraction_ = 0.0;
};

}  // namespace cydonia::render
