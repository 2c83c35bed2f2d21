#include "synth/texture/synthesis/recording.h"

#include <cstring>
#include <string>
#include <string_view>

#include "field/checked_file.h"
#include "field/files.h"

namespace cydonia::texture {
namespace {

constexpr std::string_view kMagic = "cydonia texture run 1\n";
constexpr std::uint32_t kMostLevels = 32, kMostPasses = 8;
constexpr int kMostSide = 1 << 17;

template <class T>
void put(std::string& out, const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    out.append(reinterpret_cast<const char*>(&value), sizeof value);
}
template <class T>
void put(std::string& out, const Field<T>& field) {
    put(out, field.width());
    put(out, field.height());
    out.append(reinterpret_cast<const char*>(field.data()), field.size() * sizeof(T));
}

struct Damaged {};

template <class T>
T take(std::string_view& in) {
    if (in.size() < sizeof(T)) throw Damaged{};
    T value;
    std::memcpy(&value, in.data(), sizeof value);
    in.remove_prefix(sizeof value);
    return value;
}
std::uint32_t at_most(std::string_view& in, std::uint32_t most) {
    const auto count = take<std::uint32_t>(in);
    if (count > most) throw Damaged{};
    return count;
}
template <class T>
Field<T> take_field(std::string_view& in) {
    const int width = take<int>(in), height = take<int>(in);
    if (width < 0 || height < 0 || width > kMostSide || height > kMostSide)
        throw Damaged{};
    const std::size_t bytes = std::size_t(width) * std::size_t(height) * sizeof(T);
    if (in.size() < bytes) throw Damaged{};
    Field<T> field(width, height);
    if (bytes > 0) std::memcpy(field.data(), in.data(), bytes);
    in.remove_prefix(bytes);
    return field;
}

std::string packed(const Run& run) {
    std::string out;
    put(out, run.database);
    put(out, static_cast<std::uint32_t>(run.passes.size()));
    for (std::size_t level = 0; level < run.passes.size(); ++level) {
        put(out, run.asked[level]);
        put(out, static_cast<std::uint32_t>(run.passes[level].size()));
        for (const Synthesis& pass : run.passes[level]) {
            put(out, pass.window);
            put(out, pass.places);
            put(out, pass.offsets);
        }
    }
    return out;
}

Synthesis taken_pass(std::string_view& in) {
    Synthesis pass;
    pass.window = take<Window>(in);
    pass.places = take_field<Place>(in);
    pass.offsets = take_field<std::int32_t>(in);
    const Window& w = pass.window;
    if (w.width != pass.places.width() || w.height != pass.places.height() ||
        !pass.offsets.same_shape(pass.places))
        throw Damaged{};
    return pass;
}

Run unpacked(std::string_view in) {
    Run run;
    run.database = take<std::uint64_t>(in);
    run.passes.resize(at_most(in, kMostLevels));
    for (std::vector<Synthesis>& passes : run.passes) {
        run.asked.push_back(take_field<std::uint64_t>(in));
        passes.resize(at_most(in, kMostPasses));
        for (Synthesis& pass : passes) {
            pass = taken_pass(in);
            if (!run.asked.back().empty() && !run.asked.back().same_shape(pass.places))
                throw Damaged{};
        }
    }
    return run;
}

}  // namespace

void store_run(const std::filesystem::path& file, const Run& run) {
    make_folder(file.parent_path());
    write_checked(file, kMagic, packed(run));
}

std::optional<Run> load_run(const std::filesystem::path& file) {
    const std::optional<std::string> body = read_checked(file, kMagic);
    if (!body) return std::nullopt;
    try {
        return unpacked(*body);
    } catch (const Damaged&) {
        return std::nullopt;
    }
}

}  // namespace cydonia::texture
