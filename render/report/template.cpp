#include "render/report/template.h"

#include "field/error.h"
#include "field/markup.h"

namespace cydonia::render {
namespace {

using Scopes = std::vector<const Values*>;  // the innermost scope last

std::string text_of(const std::string& name, const Scopes& scopes) {
    for (auto scope = scopes.rbegin(); scope != scopes.rend(); ++scope) {
        const auto found = (*scope)->texts.find(name);
        if (found != (*scope)->texts.end()) return found->second;
    }
    return {};
}

const std::vector<Values>* list_of(const std::string& name, const Scopes& scopes) {
    for (auto scope = scopes.rbegin(); scope != scopes.rend(); ++scope) {
        const auto found = (*scope)->lists.find(name);
        if (found != (*scope)->lists.end()) return &found->second;
    }
    return nullptr;
}

// Removes and returns the text before `mark`, and removes the mark.
std::string_view taken_until(std::string_view mark, std::string_view& text) {
    const std::size_t end = text.find(mark);
    if (end == text.npos) throw failure("a template's '{}' is missing", mark);
    const std::string_view taken = text.substr(0, end);
    text.remove_prefix(end + mark.size());
    return taken;
}

// Removes and returns the content of a part, which may hold parts of the same name.
std::string_view part_until_closed(const std::string& name, std::string_view& text) {
    const std::string close = "{{/" + name + "}}";
    const std::string opens[] = {"{{#" + name + "}}", "{{^" + name + "}}"};
    const std::string_view all = text;
    for (int depth = 1; depth > 0; --depth) {
        const std::string_view inside = taken_until(close, text);
        for (const std::string& open : opens)
            for (auto at = inside.find(open); at != inside.npos;
                 at = inside.find(open, at + 1))
                ++depth;
    }
    return all.substr(0, all.size() - text.size() - close.size());
}

void fill(std::string_view text, Scopes& scopes, std::string& page) {
    while (true) {
        const std::size_t hole = text.find("{{");
        page += text.substr(0, hole);
        if (hole == text.npos) return;
        text.remove_prefix(hole + 2);
        if (text.starts_with('{')) {
            text.remove_prefix(1);
            page += text_of(std::string(taken_until("}}}", text)), scopes);
            continue;
        }
        const std::string name(taken_until("}}", text));
        if (!name.starts_with('#') && !name.starts_with('^')) {
            page += escaped(text_of(name, scopes));
            continue;
        }
        const std::string of = name.substr(1);
        const std::string_view part = part_until_closed(of, text);
        const std::vector<Values>* list = list_of(of, scopes);
        const bool empty = list ? list->empty() : text_of(of, scopes).empty();
        if (name.starts_with('^') ? empty : !empty && !list) fill(part, scopes, page);
        if (name.starts_with('^') || !list) continue;
        for (const Values& values : *list) {
            scopes.push_back(&values);
            fill(part, scopes, page);
            scopes.pop_back();
        }
    }
}

}  // namespace

std::string filled(std::string_view text, const Values& values) {
    Scopes scopes = {&values};
    std::string page;
    fill(text, scopes, page);
    return page;
}

}  // namespace cydonia::render
