#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "field/error.h"
#include "field/files.h"

namespace cydonia {

// A folder for one test, which is removed with this object.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name =
            (std::filesystem::temp_directory_path() / "cydonia-field-XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path operator/(std::string_view name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path with(std::string_view name, std::string_view text) const {
        write_text(path_ / name, text);
        return path_ / name;
    }
    bool is_empty() const { return std::filesystem::is_empty(path_); }

  private:
    std::filesystem::path path_;
};

// Expects that `act` throws our error with this code and a message that contains `words`.
template <class Act>
void expect_error(ExitCode code, std::string_view words, const Act& act) {
    try {
        act();
        ADD_FAILURE() << "no error, expected: " << words;
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), code) << error.what();
        EXPECT_NE(std::string_view(error.what()).find(words), std::string_view::npos)
            << "'" << error.what() << "' does not say '" << words << "'";
        EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos)
            << error.what();
    }
}

// Whether `act` succeeds rather than throws our error. Any other exception fails the
// test.
template <class Act>
bool survives(const Act& act) {
    try {
        act();
        return true;
    } catch (const Error&) {
        return false;
    }
}

}  // namespace cydonia
