// RFC 7946: Polygons and MultiPolygons with a type.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "config/reader/map_formats.h"
#include "field/error.h"
#include "field/files.h"

namespace cydonia::config {
namespace {

using Json = nlohmann::json;

class Features {
  public:
    explicit Features(const std::string& file) : file_(file) {}

    void read(const Json& json) {
        const std::string kind = text_of(json, "type");
        if (kind == "FeatureCollection") {
            const auto features = json.find("features");
            if (features == json.end() || !features->is_array())
                throw wrong("a FeatureCollection has an array 'features'");
            for (const Json& feature : *features) add(feature);
        } else if (kind == "Feature") {
            add(json);
        } else {
            throw wrong("expected a FeatureCollection or a Feature");
        }
    }
    genetic::MapOptions map;

  private:
    Error wrong(const std::string& why) const {
        const auto at = number_ > 0 ? fmt::format(": feature {}", number_) : "";
        return bad_request("{}{}: {}", file_, at, why);
    }

    static std::string text_of(const Json& json, const char* key) {
        if (!json.is_object()) return {};
        const auto found = json.find(key);
        return found != json.end() && found->is_string() ? found->get<std::string>() : "";
    }

    static bool is_line(const std::string& text) {
        return !text.empty() && text.size() <= 64 &&
               std::ranges::none_of(text, [](unsigned char c) { return c < ' '; });
    }

    void add(const Json& feature) {
        ++number_;
        if (map.regions.size() >= kMostMapRegions)
            throw wrong(fmt::format("more than {} regions", kMostMapRegions));
        if (!feature.is_object() || !feature.contains("geometry"))
            throw wrong("has no geometry");
        const Json& geometry = feature["geometry"];
        const std::string kind = text_of(geometry, "type");
        if (kind != "Polygon" && kind != "MultiPolygon") return;  // labels, roads
        const Json none = Json::object();
        const Json& properties =
            feature.contains("properties") ? feature["properties"] : none;
        std::string type = text_of(properties, "type");
        if (type.empty()) type = text_of(properties, "terrain");
        if (!is_line(type))
            throw wrong("its properties need a 'type', a terrain type of the library");
        std::string name = text_of(properties, "name");
        if (!is_line(name)) name = name_of_region(map, type);
        const Json coordinates =
            geometry.contains("coordinates") ? geometry["coordinates"] : Json();
        genetic::MapRegion region{std::move(name), std::move(type), {}};
        if (!coordinates.is_array()) throw wrong("its coordinates are no array");
        if (kind == "Polygon")
            add_polygon(coordinates, region);
        else
            for (const Json& polygon : coordinates) add_polygon(polygon, region);
        if (region.outlines.empty()) throw wrong("has no outline");
        map.regions.push_back(std::move(region));
    }

    void add_polygon(const Json& rings, genetic::MapRegion& region) {
        if (!rings.is_array()) throw wrong("a polygon is an array of rings");
        for (const Json& ring : rings) {
            genetic::Outline outline;
            if (!ring.is_array()) throw wrong("a ring is an array of positions");
            for (const Json& position : ring) {
                if (!position.is_array() || position.size() < 2 ||
                    !position[0].is_number() || !position[1].is_number())
                    throw wrong("a position is [east, north]");
                const double x = position[0].get<double>(), y = position[1].get<double>();
                if (!(std::abs(x) < 1e9 && std::abs(y) < 1e9))
                    throw wrong("a position lies more than 1e9 away");
                if (++corners_ > kMostMapCorners)
                    throw wrong(fmt::format("more than {} corners", kMostMapCorners));
                outline.push_back({x, y});
            }
            if (outline.size() < 4) throw wrong("a ring has at least four positions");
            if (outline.front() != outline.back())
                throw wrong("a ring ends where it begins");
            outline.pop_back();
            region.outlines.push_back(std::move(outline));
        }
    }

    const std::string& file_;
    std::size_t number_ = 0, corners_ = 0;
};

}  // namespace

genetic::MapOptions map_from_geojson(const std::filesystem::path& file) {
    const std::string name = file.string();
    Features features(name);
    features.map.window = {};
    const std::string text = read_text(file, kMostMapBytes);
    Json json;
    try {
        json = Json::parse(text);
    } catch (const Json::parse_error& error) {
        const std::size_t at = std::min(error.byte, text.size());
        std::string why = error.what();
        if (const auto dash = why.find(" - "); dash != why.npos) why.erase(0, dash + 3);
        throw bad_request("{}:{}: no JSON: {}", name,
                          1 + std::ranges::count(text.substr(0, at), '\n'), why);
    }
    features.read(json);
    return std::move(features.map);
}

}  // namespace cydonia::config
