#include <algorithm>
#include <string>
#include <vector>

#include "tests/config/scene_file.h"

namespace cydonia::config {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> cases() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(golden_folder()))
        if (entry.path().extension() == ".txt")
            names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    return names;
}

// The lines "#--set KEY=VALUE" that a case opens with.
std::vector<std::string> overrides_in(const std::string& text) {
    const std::string mark = "#--set ";
    std::vector<std::string> overrides;
    for (std::size_t at = 0; text.compare(at, mark.size(), mark) == 0;) {
        const std::size_t end = text.find('\n', at);
        overrides.push_back(text.substr(at + mark.size(), end - at - mark.size()));
        at = end + 1;
    }
    return overrides;
}

class Message : public testing::TestWithParam<std::string> {};

// Case by case: tests/golden/config/<case>.toml and the messages it must give.
TEST_P(Message, IsTheGoldenOne) {
    fs::current_path(golden_folder());  // so that paths in messages are short
    const std::string scene = GetParam() + ".toml";
    std::string message;
    try {
        Scene::load(scene, overrides_in(golden_text(scene)));
    } catch (const Error& error) {
        message = std::string(error.what()) + '\n';
        EXPECT_EQ(error.code(), ExitCode::kBadRequest);
    }
    const fs::path kept = fs::temp_directory_path() / (GetParam() + ".txt");
    if (message != golden_text(GetParam() + ".txt")) write_text(kept, message);
    EXPECT_EQ(message, golden_text(GetParam() + ".txt")) << "kept as " << kept;
}

INSTANTIATE_TEST_SUITE_P(Config, Message, testing::ValuesIn(cases()),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace cydonia::config
