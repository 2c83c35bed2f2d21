#include "app/watch.h"

#include <fmt/core.h>

#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <thread>

#include "app/console.h"
#include "app/interrupt.h"
#include "app/pipeline/pipeline.h"
#include "config/reader/scene.h"
#include "field/data.h"
#include "field/error.h"
#include "field/files.h"
#include "render/cameras/cameras.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

constexpr std::chrono::milliseconds kEvery{100};

// The files that the scene is made of, and when each was written.
using Files = std::map<fs::path, fs::file_time_type>;

Files read_times(Files files) {
    for (auto& [file, time] : files) {
        std::error_code none;
        time =
            fs::last_write_time(file, none);  // the earliest possible time if it is gone
    }
    return files;
}

Files files_of(const config::SceneSpec& scene) {
    Files files;
    for (const config::StageSpec& stage : scene.stages)
        for (const Source& source : stage.sources) files[source.path];
    if (scene.render.colour.config) files[scene.render.colour.config->path];
    return files;
}

std::vector<std::string> pictures_of(const config::SceneSpec& scene,
                                     const Request& request) {
    const auto cameras =
        scene.render.cameras.empty() ? render::default_cameras() : scene.render.cameras;
    std::vector<std::string> pictures;
    for (const render::CameraOptions& camera : cameras)
        pictures.push_back(
            fmt::format("frames/{}.{}.png", camera.name, name_of(*request.preview)));
    return pictures;
}

// Writes the state that the page reads every half second.
void tell_page(const fs::path& folder, int drawn,
               const std::vector<std::string>& pictures, const std::string& error) {
    const nlohmann::json state = {
        {"drawn", drawn}, {"pictures", pictures}, {"error", error}};
    using Replace = nlohmann::json::error_handler_t;
    write_text(folder / "watch.js",
               "show(" + state.dump(-1, ' ', true, Replace::replace) + ");\n");
}

}  // namespace

void watch(const Request& asked) {
    using Clock = std::chrono::steady_clock;
    Request request = asked;
    if (!request.preview) request.preview = render::Style::kNatural;
    const config::SceneSpec first =
        config::Scene::load(request.scene, request.overrides).at(0.0);
    if (request.output.empty()) request.output = fs::path("out") / first.name;
    make_folder(request.output);
    write_text(request.output / "watch.html", read_text(data_file("report/watch.html")));

    Files files = files_of(first);
    std::vector<std::string> pictures = pictures_of(first, request);
    for (int drawn = 1;; ++drawn) {
        files[request.scene];
        files = read_times(std::move(files));
        const Clock::time_point begin = Clock::now();
        std::string wrong;
        try {
            const config::SceneSpec scene =
                config::Scene::load(request.scene, request.overrides).at(0.0);
            Files now = files_of(scene);
            now[request.scene];
            now = read_times(std::move(now));
            pictures = pictures_of(scene, request);
            Console console(style_for_stderr(true));
            make(request, Goal::kFrames, static_cast<Progress&>(console));
            files = std::move(now);
        } catch (const Error& error) {
            wrong = error.what();
            fmt::print(stderr, "cydonia: {}\n", wrong);
        }
        tell_page(request.output, drawn, pictures, wrong);
        if (wrong.empty() && !request.quiet) {
            const std::chrono::duration<double> took = Clock::now() - begin;
            fmt::print(
                "drawn in {:.2f} s{}\n", took.count(),
                drawn == 1 ? "; open " + (request.output / "watch.html").string() : "");
            std::fflush(stdout);
        }
        while (read_times(files) == files) {
            if (interrupt_signal() != 0) throw Interrupted{};
            std::this_thread::sleep_for(kEvery);
        }
    }
}

}  // namespace cydonia
