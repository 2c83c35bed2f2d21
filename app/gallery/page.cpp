#include "app/gallery/page.h"

#include <fmt/core.h>

#include "app/console.h"
#include "field/markup.h"

namespace cydonia {
namespace {

constexpr std::string_view kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Cydonia: gallery</title>
<style>
body { max-width: 70rem; margin: 2rem auto; padding: 0 1rem; font: 16px/1.5 sans-serif;
       color: #222; background: #fff }
nav a { margin-right: .8em }
section { margin-top: 3rem; border-top: 1px solid #ccc }
figure { display: inline-block; margin: 0 .5rem .5rem 0; vertical-align: bottom }
figcaption { font-size: 85%; color: #666 }
img { max-width: 100%; height: 18rem; width: auto }
pre { white-space: pre-wrap; overflow-wrap: anywhere; font: inherit }
code { background: #eee; padding: .2em .4em; overflow-wrap: anywhere }
.failed { color: #b00 }
@media (prefers-color-scheme: dark) {
    body { color: #ddd; background: #1b1b1b } a { color: #8bf } code { background: #333 }
    section { border-color: #444 } figcaption { color: #999 } .failed { color: #f77 }
}
</style>
</head>
<body>
)";

std::string links_to(const std::vector<Exhibit>& exhibits) {
    std::string links;
    for (const Exhibit& e : exhibits) {
        links += fmt::format("<a href=\"#{0}\">{0}</a>\n", escaped(e.name));
    }
    return "<nav>\n" + links + "</nav>\n";
}

std::string figure_of(const Exhibit::Picture& picture) {
    return fmt::format(
        "<figure><img src=\"{0}\" alt=\"{1}\" loading=\"lazy\">"
        "<figcaption>{1}</figcaption></figure>\n",
        escaped(picture.file), escaped(picture.label));
}

std::string section_of(const Exhibit& e) {
    std::string html = fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n", escaped(e.name),
                                   escaped(e.title));
    for (const Exhibit::Picture& picture : e.pictures) html += figure_of(picture);
    if (!e.about.empty()) html += fmt::format("<pre>{}</pre>\n", escaped(e.about));
    html += fmt::format("<p><code>{}</code></p>\n", escaped(e.command));
    if (e.failure.empty()) {
        html += fmt::format("<p>Synthesis {}, render {}</p>\n",
                            duration_text(e.synthesis), duration_text(e.render));
    } else {
        html +=
            fmt::format("<pre class=\"failed\">Not made: {}</pre>\n", escaped(e.failure));
    }
    return html + "</section>\n";
}

}  // namespace

std::string page_of(const std::vector<Exhibit>& exhibits) {
    std::string html(kHead);
    html += "<h1>Cydonia: gallery</h1>\n" + links_to(exhibits);
    for (const Exhibit& e : exhibits) html += section_of(e);
    return html + "</body>\n</html>\n";
}

std::string leading_comment(std::string_view scene) {
    std::string comment;
    while (scene.starts_with('#')) {
        const std::size_t end = scene.find('\n');
        std::string_view line = scene.substr(1, end == scene.npos ? end : end - 1);
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (line.starts_with(' ')) line.remove_prefix(1);
        comment += std::string(line) + "\n";
        scene.remove_prefix(end == scene.npos ? scene.size() : end + 1);
    }
    return comment;
}

}  // namespace cydonia
