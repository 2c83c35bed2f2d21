#include "app/manual.h"

#include <regex>
#include <sstream>
#include <vector>

#include "field/data.h"
#include "field/files.h"

namespace cydonia {
namespace {

constexpr std::size_t kWidth = 96;  // columns, of a line with its comment

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::string trimmed(const std::string& text) {
    const auto begin = text.find_first_not_of(' ');
    return begin == text.npos
               ? ""
               : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

// The cells of a row "| a | b |".
std::vector<std::string> cells_of(const std::string& row) {
    std::vector<std::string> cells;
    std::istringstream in(row.substr(1));
    for (std::string cell; std::getline(in, cell, '|');) cells.push_back(trimmed(cell));
    return cells;
}

// Text without its links; code stays.
std::string plain(std::string text) {
    static const std::regex link(R"(\[([^\]]*)\]\([^)]*\))");
    text = std::regex_replace(text, link, "$1");
    std::erase(text, '`');
    return text;
}

// The key that a line begins with; empty if none.
std::string key_of(const std::string& line) {
    std::size_t end = 0;
    while (end < line.size() &&
           (std::islower(static_cast<unsigned char>(line[end])) || line[end] == '_'))
        ++end;
    return end > 0 && line.compare(end, 3, " = ") == 0 ? line.substr(0, end) : "";
}

bool has_comment(const std::string& line) {
    char quote = 0;
    for (const char c : line) {
        if (quote != 0)
            quote = c == quote ? 0 : quote;
        else if (c == '"' || c == '\'')
            quote = c;
        else if (c == '#')
            return true;
    }
    return false;
}

// The keys of a table in one line: "{ count = 30, apart = 500.0 }".
std::vector<std::string> inner_keys(const std::string& line) {
    static const std::regex key(R"([{,] *([a-z_]+) = )");
    std::vector<std::string> keys;
    if (line.find("= {") == line.npos) return keys;
    for (std::sregex_iterator at(line.begin(), line.end(), key), end; at != end; ++at)
        keys.push_back((*at)[1]);
    return keys;
}

// The text as comment lines of at most kWidth columns.
std::string above(const std::string& comment) {
    std::string text, line = "#";
    std::istringstream words(comment);
    for (std::string word; words >> word;) {
        if (line.size() + 1 + word.size() > kWidth) {
            text += line + '\n';
            line = "#";
        }
        line += ' ' + word;
    }
    return text + line + '\n';
}

// The method of the stage whose header is at `index`.
std::string method_after(const std::vector<std::string>& lines, std::size_t index) {
    for (std::size_t i = index + 1; i < lines.size() && !lines[i].starts_with('['); ++i)
        if (key_of(lines[i]) == "method") {
            const auto begin = lines[i].find('"') + 1;
            return lines[i].substr(begin, lines[i].find('"', begin) - begin);
        }
    return "";
}

}  // namespace

Manual::Manual(const std::string& markdown) {
    static const std::regex heading(R"re(##+ `\[+([a-z_.]+)\]+`(?:.*"([a-z]+)".*)?)re");
    constexpr std::size_t kKey = 0, kUnit = 1, kRange = 3, kMeaning = 4, kCells = 5;
    std::string table;
    for (const std::string& line : lines_of(markdown)) {
        if (std::smatch match; std::regex_match(line, match, heading)) {
            table = match[1].str() + (match[2].matched ? " " + match[2].str() : "");
        } else if (line.starts_with("#")) {
            table = line == "## Top level" ? "" : "(none)";
        } else if (line.starts_with("| `")) {
            const auto cells = cells_of(line);
            if (cells.size() != kCells) continue;
            std::string meaning = plain(cells[kMeaning]);
            // The unit lists the words that may be chosen.
            if (cells[kRange].starts_with('`'))
                meaning = plain(cells[kRange]) + ": " + meaning;
            if (!cells[kUnit].empty()) meaning += " (" + plain(cells[kUnit]) + ")";
            meanings_[table + '.' + plain(cells[kKey])] = meaning;
        }
    }
}

Manual Manual::load() { return Manual(read_text(data_file("docs/scene-file.md"))); }

std::string Manual::meaning(const std::string& table, const std::string& key) const {
    const auto found = meanings_.find(table + '.' + key);
    return found == meanings_.end() ? "" : found->second;
}

std::string commented(const std::string& scene, const Manual& manual) {
    const std::vector<std::string> lines = lines_of(scene);
    std::string text, table, path;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string& line = lines[i];
        if (line.starts_with('[')) {
            const auto begin = line.find_first_not_of('[');
            table = path = line.substr(begin, line.find(']') - begin);
            if (path == "terrain.stage") table += ' ' + method_after(lines, i);
        }
        const std::string key = key_of(line);
        std::string comment = manual.meaning(table, key);
        for (const std::string& inner : inner_keys(line)) {
            const std::string meaning =
                manual.meaning(path.empty() ? key : path + '.' + key, inner);
            if (meaning.empty()) continue;
            comment += (comment.empty() ? "" : "; ") + inner + ": " + meaning;
        }
        if (comment.empty() || has_comment(line)) {
            text += line + '\n';
            continue;
        }
        if (line.size() + 4 + comment.size() <= kWidth)
            text += line + "  # " + comment + '\n';
        else
            text += above(comment) + line + '\n';
    }
    return text;
}

}  // namespace cydonia
