#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "field/field.h"
#include "field/sun.h"

namespace cydonia::render {

// A picture that the page carries, small, and the file beside the page that it is of.
struct ReportPicture {
    std::string label;          // "overhead"
    std::string file;           // relative to the page: "frames/overhead.png"
    std::string jpeg;           // bytes
    int width = 0, height = 0;  // of the JPEG, pixels
};

struct ReportVideo {
    std::string label;
    std::string file;  // relative to the page
    std::string mp4;   // bytes that the page carries; empty: played from the file
    std::optional<ReportPicture> poster;
};

struct ReportRow {
    std::string name, value;
};
struct ReportTable {
    std::string title;
    std::vector<ReportRow> rows;
};

// An image that the land hides.
struct ReportImage {
    std::string name;
    Sun sun;
    std::string verdict;  // one line: how well it reads
    bool passed = true;
    // Of the land's shape: 1 where it is dark; 1 where it counts, empty: everywhere.
    Field<std::uint8_t> target, window;
    std::vector<ReportPicture> pictures;  // overlay, cast, target, sun clock
};

struct ReportStep {
    std::string name;
    double seconds = 0.0;
    std::string options;  // "key = value" lines; empty: none
};

// All that the page shows. What is empty is left out of it.
struct Report {
    std::string title;
    std::vector<ReportRow> facts;  // the few that stand under the title
    std::vector<ReportPicture> frames;
    std::vector<ReportVideo> videos;
    std::vector<ReportImage> images;
    std::vector<ReportPicture> relief;  // hillshade, masks
    std::vector<ReportStep> stages, other_steps;
    std::vector<ReportTable> figures;
    std::string scene;  // resolved, as text
    std::string version;

    // The land to turn, at most kReportSamples a side; empty: none is shown.
    Field<float> heights;       // metres
    Field<std::uint8_t> water;  // 1 where it is wet; empty: dry
    double spacing = 1.0;       // metres
    Sun sun = {};               // the one that it is first seen under, but near it
    std::string three;          // three.js; empty: the land is shown from above only
};

inline constexpr int kReportSamples = 512;

// The page, whole: no file but itself is needed to read it, and nothing of it is fetched.
// Its template, style and scripts are the data files report/*. Throws failure() where one
// is missing.
std::string report_page(const Report& report);

// A file as the page carries it: no side longer than `most` pixels. Throws bad_request as
// read_rgba does.
ReportPicture report_picture(const std::filesystem::path& folder, const std::string& file,
                             const std::string& label, int most);

// Debian's three.js (package libjs-three), minified; empty where it is not installed.
std::string three_js();

}  // namespace cydonia::render
