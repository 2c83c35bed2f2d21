#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "config/reader/map_formats.h"
#include "config/reader/thesis.h"
#include "field/error.h"
#include "field/files.h"

namespace cydonia::config {
namespace {

// Reads a map line by line; a face has the type that was named last.
class ThesisMap {
  public:
    explicit ThesisMap(const std::filesystem::path& file) : file_(file) {
        map_.window = {};
    }

    genetic::MapOptions read() {
        std::istringstream lines(read_text(file_, kMostMapBytes));
        for (std::string line; std::getline(lines, line);) {
            ++line_;
            std::istringstream words(line.substr(0, line.find('#')));
            std::string record;
            if (!(words >> record)) continue;
            if (record == "v")
                add_corner(words);
            else if (record == "tt")
                name_type(words);
            else if (record == "f")
                add_face(words);
            else
                throw wrong(fmt::format("unknown record '{}'; known: v, tt, f",
                                        record.substr(0, 40)));
        }
        return std::move(map_);
    }

  private:
    Error wrong(const std::string& why) const {
        return bad_request("{}:{}: {}", file_.string(), line_, why);
    }

    void add_corner(std::istream& words) {
        double x = 0.0, y = 0.0;
        if (!(words >> x >> y) || !(std::abs(x) < 1e9 && std::abs(y) < 1e9))
            throw wrong("a corner is 'v EAST NORTH'");
        if (corners_.size() == kMostMapCorners)
            throw wrong(fmt::format("more than {} corners", kMostMapCorners));
        corners_.push_back({x, y});
    }

    void name_type(std::istream& words) {
        if (!(words >> type_) || type_.size() > 64)
            throw wrong("a terrain type is 'tt NAME'");
    }

    void add_face(std::istream& words) {
        if (type_.empty()) throw wrong("a face needs a terrain type before it: tt NAME");
        if (map_.regions.size() == kMostMapRegions)
            throw wrong(fmt::format("more than {} regions", kMostMapRegions));
        genetic::Outline outline;
        for (std::string word; words >> word;) {
            outline.push_back(corner_called(word));
            if (++used_ > kMostMapCorners)
                throw wrong(fmt::format("more than {} corners", kMostMapCorners));
        }
        if (outline.size() < 3) throw wrong("a face has at least three corners");
        map_.regions.push_back(
            {name_of_region(map_, type_), type_, {std::move(outline)}});
    }

    // Counted from the first, or back from the last, as in OBJ files.
    const std::array<double, 2>& corner_called(const std::string& word) const {
        char* end = nullptr;
        const long long index = std::strtoll(word.c_str(), &end, 10);
        const auto count = static_cast<long long>(corners_.size());
        const long long at = index < 0 ? count + index : index - 1;
        if (*end != '\0' || at < 0 || at >= count)
            throw wrong(fmt::format("there is no corner '{}' yet, of {}",
                                    word.substr(0, 40), count));
        return corners_[static_cast<std::size_t>(at)];
    }

    const std::filesystem::path& file_;
    genetic::MapOptions map_;
    std::vector<std::array<double, 2>> corners_;
    std::size_t used_ = 0;  // corners of all faces
    std::string type_;
    int line_ = 0;
};

}  // namespace

genetic::MapOptions map_from_thesis(const std::filesystem::path& file) {
    return ThesisMap(file).read();
}

}  // namespace cydonia::config
