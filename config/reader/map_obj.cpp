// The thesis' own form, after Wavefront's OBJ (Saunders 2006, figure V.10).

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "config/reader/map_formats.h"
#include "field/error.h"
#include "field/files.h"

namespace cydonia::config {

genetic::MapOptions map_from_obj(const std::filesystem::path& file) {
    genetic::MapOptions map;
    map.window = {};
    std::vector<std::array<double, 2>> corners;
    std::size_t used = 0;
    std::string type;
    std::istringstream lines(read_text(file, kMostMapBytes));
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const auto wrong = [&](const std::string& why) {
            return bad_request("{}:{}: {}", file.string(), number, why);
        };
        std::istringstream words(line.substr(0, line.find('#')));
        std::string record;
        if (!(words >> record)) continue;
        if (record == "v") {
            double x = 0.0, y = 0.0;
            if (!(words >> x >> y) || !(std::abs(x) < 1e9 && std::abs(y) < 1e9))
                throw wrong("a corner is 'v EAST NORTH'");
            if (corners.size() == kMostMapCorners)
                throw wrong(fmt::format("more than {} corners", kMostMapCorners));
            corners.push_back({x, y});
        } else if (record == "tt") {
            if (!(words >> type) || type.size() > 64)
                throw wrong("a terrain type is 'tt NAME'");
        } else if (record == "f") {
            if (type.empty())
                throw wrong("a face needs a terrain type before it: tt NAME");
            if (map.regions.size() == kMostMapRegions)
                throw wrong(fmt::format("more than {} regions", kMostMapRegions));
            genetic::Outline outline;
            for (std::string word; words >> word;) {
                char* end = nullptr;
                const long long index = std::strtoll(word.c_str(), &end, 10);
                const auto n = static_cast<long long>(corners.size());
                // From the first, or back from the last, as in OBJ files.
                const long long at = index < 0 ? n + index : index - 1;
                if (*end != '\0' || at < 0 || at >= n)
                    throw wrong(fmt::format("there is no corner '{}' yet, of {}",
                                            word.substr(0, 40), n));
                if (++used > kMostMapCorners)
                    throw wrong(fmt::format("more than {} corners", kMostMapCorners));
                outline.push_back(corners[static_cast<std::size_t>(at)]);
            }
            if (outline.size() < 3) throw wrong("a face has at least three corners");
            map.regions.push_back(
                {name_of_region(map, type), type, {std::move(outline)}});
        } else {
            throw wrong(fmt::format("unknown record '{}'; known: v, tt, f",
                                    record.substr(0, 40)));
        }
    }
    return map;
}

}  // namespace cydonia::config
