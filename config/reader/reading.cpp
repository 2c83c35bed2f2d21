#include "config/reader/reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cydonia::config {
namespace {

constexpr std::size_t kMostKeys = 4096;

double frame_of(const TrackKey& key) { return key.frame; }

// Reads one [frame, value], whose frame must be greater than those before.
std::optional<TrackKey> track_key(Reading& reading, const Value& value,
                                  const std::string& path,
                                  const std::vector<TrackKey>& before) {
    const auto* pair = elements(reading, value, path, 2, 2);
    double frame = 0.0;
    if (!pair ||
        !read_constant(reading, (*pair)[0], path, frame, Number{from(-1e6, 1e6)}))
        return std::nullopt;
    if (before.empty() || frame > before.back().frame)
        return TrackKey{frame, &(*pair)[1]};
    reading.mistakes.push_back(
        {(*pair)[0].at, path,
         fmt::format("frame {} must come after frame {}", frame, before.back().frame)});
    return std::nullopt;
}

// The one or two keys of a checked track that matter at a frame.
std::vector<TrackKey> keys_around(const Value& track, double frame) {
    const auto& array = std::get<Value::Array>(track.find("keys")->data);
    const auto key_of = [](const Value& value) {
        const auto& pair = std::get<Value::Array>(value.data);
        const auto* whole = std::get_if<std::int64_t>(&pair[0].data);
        return TrackKey{
            whole ? static_cast<double>(*whole) : std::get<double>(pair[0].data),
            &pair[1]};
    };
    const auto next = std::ranges::upper_bound(
        array, frame, {}, [&](const Value& value) { return key_of(value).frame; });
    std::vector<TrackKey> keys;
    if (next != array.begin()) keys.push_back(key_of(*(next - 1)));
    if (next != array.end()) keys.push_back(key_of(*next));
    return keys;
}

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
    if (reading.checked) return keys_around(track, reading.frame);
    for (const auto& entry : std::get<Value::Table>(track.data))
        if (entry.key != "keys") {
            reading.mistakes.push_back(
                {entry.at, path, fmt::format("unknown key '{}' beside keys", entry.key)});
            return {};
        }
    const std::string keys_path = path + ".keys";
    const auto* array = elements(reading, *track.find("keys"), keys_path, 1, kMostKeys);
    std::vector<TrackKey> keys;
    for (std::size_t i = 0; array && i < array->size(); ++i) {
        const auto key = track_key(reading, (*array)[i], element(keys_path, i), keys);
        if (!key) return {};
        keys.push_back(*key);
        reading.key_frames.insert(key->frame);
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
