#include "synth/texture/synthesis/recording.h"

#include <string>
#include <string_view>

#include "field/archive.h"
#include "field/files.h"

namespace cydonia::texture {
namespace {

constexpr std::string_view kKind = "cydonia texture run 2\n";
constexpr std::uint32_t kMostLevels = 32, kMostPasses = 8;
constexpr int kMostSide = 1 << 17;

void put(ArchiveWriter& out, const Run& run) {
    out.value(run.database);
    out.value(static_cast<std::uint32_t>(run.passes.size()));
    for (std::size_t level = 0; level < run.passes.size(); ++level) {
        out.field(run.asked[level]);
        out.value(static_cast<std::uint32_t>(run.passes[level].size()));
        for (const Synthesis& pass : run.passes[level]) {
            out.value(pass.window);
            out.field(pass.origins);
            out.field(pass.offsets);
        }
    }
}

template <class T>
Field<T> taken_field(ArchiveReader& in) {
    Field<T> field = in.field<T>();
    in.expect(field.width() <= kMostSide && field.height() <= kMostSide);
    return field;
}

Synthesis taken_pass(ArchiveReader& in) {
    Synthesis pass;
    pass.window = in.value<Window>();
    pass.origins = taken_field<Origin>(in);
    pass.offsets = taken_field<std::int32_t>(in);
    in.expect(pass.window.width == pass.origins.width() &&
              pass.window.height == pass.origins.height() &&
              pass.offsets.same_shape(pass.origins));
    return pass;
}

Run taken_run(ArchiveReader& in) {
    Run run;
    run.database = in.value<std::uint64_t>();
    run.passes.resize(in.at_most<std::uint32_t>(kMostLevels));
    for (std::vector<Synthesis>& passes : run.passes) {
        run.asked.push_back(taken_field<std::uint64_t>(in));
        passes.resize(in.at_most<std::uint32_t>(kMostPasses));
        for (Synthesis& pass : passes) {
            pass = taken_pass(in);
            in.expect(run.asked.back().empty() ||
                      run.asked.back().same_shape(pass.origins));
        }
    }
    return run;
}

}  // namespace

void store_run(const std::filesystem::path& file, const Run& run) {
    make_folder(file.parent_path());
    write_archive(file, kKind, archive_of([&](ArchiveWriter& out) { put(out, run); }));
}

std::optional<Run> load_run(const std::filesystem::path& file) {
    const std::optional<std::string> body = read_archive(file, kKind);
    if (!body) return std::nullopt;
    return read_back(*body, taken_run);
}

}  // namespace cydonia::texture
