#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "config/reader/scene.h"
#include "field/error.h"
#include "field/files.h"
#include "tests/field/temporary_folder.h"

namespace cydonia::config {

inline std::filesystem::path golden_folder() {
    return std::filesystem::path(CYDONIA_SOURCE_DIR) / "tests" / "golden" / "config";
}
inline std::string golden_text(const std::string& name) {
    return read_text(golden_folder() / name);
}

// A temporary folder with the files that the golden scenes name.
class SceneFile : public testing::Test {
  protected:
    SceneFile() {
        for (const char* name :
             {"ridges.svg", "profile.png", "profile.csv", "kinds.toml"})
            std::filesystem::copy_file(golden_folder() / name, folder_ / name);
    }

    Scene load(const std::string& text, const std::vector<std::string>& overrides = {}) {
        std::ofstream(file_, std::ios::binary) << text;
        return Scene::load(file_, overrides);
    }
    // The message of load() without the file's folder; empty when the scene is accepted.
    std::string complaint(const std::string& text,
                          const std::vector<std::string>& overrides = {}) {
        try {
            load(text, overrides);
            return "";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::kBadRequest);
            std::string message = error.what();
            const std::string prefix = folder_.string() + "/";
            for (auto at = message.find(prefix); at != message.npos;
                 at = message.find(prefix))
                message.erase(at, prefix.size());
            return message;
        }
    }

    const TemporaryFolder own_;
    const std::filesystem::path folder_ = own_.path();
    const std::filesystem::path file_ = folder_ / "scene.toml";
};

// The smallest scene, with only what a stage needs.
inline const std::string kLeastScene =
    "[[terrain.stage]]\n"
    "method = \"distance\"\n"
    "group = [{ peaks = { count = 3 } }]\n";

}  // namespace cydonia::config
