#include "app/gallery/gallery.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/commands.h"

namespace cydonia {

void add_gallery(CLI::App& app, Action& action) {
    const auto request = std::make_shared<Request>();
    const auto folder = std::make_shared<std::filesystem::path>();
    const auto all_cameras = std::make_shared<bool>(false);
    request->quality = render::Quality::kDraft;
    CLI::App* command =
        add_command(app, {"gallery", "Render every scene of a folder, on one page",
                          "gallery && xdg-open out/gallery/index.html"});
    command->add_option("FOLDER", *folder, "holds */scene.toml [the scenes that ship]")
        ->type_name("");
    command->add_flag("--quiet", request->quiet, "print errors only");
    command->add_flag("--all-cameras", *all_cameras, "not only the first of each scene");
    add_effort_options(*command, *request);
    command->callback([request, folder, all_cameras, &action] {
        request->first_camera_only = !*all_cameras;
        action = [request, folder] {
            Console console(style_for_stderr(request->quiet));
            make_gallery(*folder, *request, console);
        };
    });
}

}  // namespace cydonia
