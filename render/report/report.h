#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "field/field.h"
#include "field/sun.h"

namespace cydonia::render {

// A small picture in the page, and the file beside the page that it was made from.
struct ReportPicture {
    std::string label;          // "overhead"
    std::string file;           // relative to the page: "frames/overhead.png"
    std::string jpeg;           // bytes
    int width = 0, height = 0;  // of the JPEG, pixels
};

struct ReportVideo {
    std::string label;
    std::string file;  // relative to the page
    std::string mp4;   // bytes within the page; when empty the file is played
    std::optional<ReportPicture> poster;
};

struct ReportRow {
    std::string name, value;
};
struct ReportTable {
    std::string title;
    std::vector<ReportRow> rows;
};

// A shadow image that the land shows under one sun.
struct ReportImage {
    std::string name;
    Sun sun;
    std::string verdict;  // one line: how well it reads
    bool passed = true;
    // Masks of the land's shape: 1 where the image is dark; 1 where it counts, or empty
    // where it counts everywhere.
    Field<std::uint8_t> target, window;
    std::vector<ReportPicture> pictures;  // overlay, cast, target, sun clock
};

struct ReportStep {
    std::string name;
    double seconds = 0.0;
    std::string options;  // "key = value" lines; empty: none
};

// Everything that the page shows. Empty parts are left out.
struct Report {
    std::string title;
    std::vector<ReportRow> facts;  // shown under the title
    std::vector<ReportPicture> frames;
    std::vector<ReportVideo> videos;
    std::vector<ReportImage> images;
    std::vector<ReportPicture> relief;  // hillshade, masks
    std::vector<ReportStep> stages, other_steps;
    std::vector<ReportTable> figures;
    std::string scene;  // resolved, as text
    std::string version;

    // The land that can be turned, at most kReportSamples a side; empty to show none.
    Field<float> heights;       // metres
    Field<std::uint8_t> water;  // 1 where it is wet; empty: dry
    double spacing = 1.0;       // metres
    Sun sun = {};               // the sun at first
    std::string
        three;  // source of three.js; when empty the land is shown from above only
};

inline constexpr int kReportSamples = 512;

// The whole page, which needs no other file and fetches nothing. Its template, style and
// scripts are the data files report/*. Throws failure() when one is missing.
std::string report_page(const Report& report);

// A picture for the page, made from a file and reduced to at most `most` pixels a side.
// Throws bad_request as read_rgba does.
ReportPicture report_picture(const std::filesystem::path& folder, const std::string& file,
                             const std::string& label, int most);

// The source of Debian's three.js (package libjs-three), or nothing when it is not
// installed.
std::string three_js();

}  // namespace cydonia::render
