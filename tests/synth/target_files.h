#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "field/error.h"
#include "field/image.h"
#include "field/progress.h"
#include "synth/pareidolia/options.h"

namespace cydonia::pareidolia {

// Pictures as files that a scene could name, in a folder of the test's own.
class TargetFiles : public testing::Test {
  protected:
    TargetFiles() { std::filesystem::create_directories(folder_); }
    ~TargetFiles() override { std::filesystem::remove_all(folder_); }

    Source file(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return open_source(folder_ / name);
    }
    // Grey, 0 black to 255 white.
    Source png(const std::string& name, const Field<std::uint8_t>& grey) const {
        write_png(folder_ / name, grey);
        return open_source(folder_ / name);
    }
    // What is inside a drawing of width x height.
    Source svg(const std::string& name, int width, int height,
               const std::string& shapes) const {
        return file(name, fmt::format("<svg xmlns='http://www.w3.org/2000/svg' "
                                      "viewBox='0 0 {} {}'>{}</svg>",
                                      width, height, shapes));
    }

    const std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() /
        ("cydonia_targets_" + std::to_string(::getpid()));
};

// Keeps the messages to the user.
struct Told final : Progress {
    void step(std::string_view) override {}
    void report(double) override {}
    void note(std::string_view sentence) override { notes.append(sentence) += '\n'; }
    void warn(std::string_view sentence) override { warnings.append(sentence) += '\n'; }
    std::string notes, warnings;
};

template <class Act>
std::string refusal(const Act& act) {
    try {
        act();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::kBadRequest);
        return error.what();
    }
    return "";
}

inline bool contains(const std::string& text, std::string_view words) {
    return text.find(words) != std::string::npos;
}

// A rectangle [x0, x1) x [y0, y1) of `inside` on white.
inline Field<std::uint8_t> grey_box(int width, int height, int x0, int y0, int x1, int y1,
                                    std::uint8_t inside = 0) {
    Field<std::uint8_t> grey(width, height, 255);
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) grey(x, y) = inside;
    return grey;
}

}  // namespace cydonia::pareidolia
