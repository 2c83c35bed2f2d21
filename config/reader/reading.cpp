#include "config/reader/reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cydonia::config {
namespace {

constexpr std::size_t kMostKeys = 4096;

double frame_of(const TrackKey& key) { return key.frame; }

}  // namespace

std::string Record::text() const {
    std::vector<std::string> sorted = lines;
    std::ranges::sort(sorted);
    std::string text;
    for (const auto& line : sorted) text += line + '\n';
    return text;
}

void Record::append(const std::string& prefix, const Record& part) {
    for (const auto& line : part.lines) lines.push_back(prefix + '.' + line);
    sources.insert(sources.end(), part.sources.begin(), part.sources.end());
}

const Value::Array* elements(Reading& reading, const Value& value,
                             const std::string& path, std::size_t least,
                             std::size_t most) {
    const auto* array = std::get_if<Value::Array>(&value.data);
    if (array && array->size() >= least && array->size() <= most) return array;
    const auto count =
        least == most ? fmt::format("{}", most) : fmt::format("{} to {}", least, most);
    reading.mistakes.push_back(
        {value.at, path,
         fmt::format("expected an array of {}, found {}", count, described(value))});
    return nullptr;
}

std::vector<TrackKey> track_keys(Reading& reading, const Value& track,
                                 const std::string& path) {
    const auto& table = std::get<Value::Table>(track.data);
    for (const auto& entry : table)
        if (entry.key != "keys") {
            reading.mistakes.push_back(
                {entry.at, path, fmt::format("unknown key '{}' beside keys", entry.key)});
            return {};
        }
    const std::string keys_path = path + ".keys";
    const auto* array = elements(reading, *track.find("keys"), keys_path, 1, kMostKeys);
    if (!array) return {};

    std::vector<TrackKey> keys;
    for (std::size_t i = 0; i < array->size(); ++i) {
        const std::string key_path = element(keys_path, i);
        const auto* pair = elements(reading, (*array)[i], key_path, 2, 2);
        if (!pair) return {};
        double frame = 0.0;
        if (!read_constant(reading, (*pair)[0], key_path, frame, Number{from(-1e6, 1e6)}))
            return {};
        if (!keys.empty() && frame <= keys.back().frame) {
            reading.mistakes.push_back({(*pair)[0].at, key_path,
                                        fmt::format("frame {} must come after frame {}",
                                                    frame, keys.back().frame)});
            return {};
        }
        keys.push_back({frame, &(*pair)[1]});
        reading.key_frames.insert(frame);
    }
    return keys;
}

TrackPoint track_point(const std::vector<TrackKey>& keys, double frame) {
    const auto next = std::ranges::upper_bound(keys, frame, {}, frame_of);
    if (next == keys.begin()) return {0, 0.0};
    const auto index = static_cast<std::size_t>(next - keys.begin()) - 1;
    if (next == keys.end()) return {index, 0.0};
    return {index, (frame - keys[index].frame) / (next->frame - keys[index].frame)};
}

}  // namespace cydonia::config
