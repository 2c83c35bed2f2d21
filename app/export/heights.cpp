// The heights for terrain, map and game programs.
#include <fmt/core.h>

#include <algorithm>

#include "app/export/export.h"
#include "app/pipeline/memory.h"
#include "field/files.h"

namespace cydonia {
namespace {

std::string file_name(const Job& job, HeightFormat format) {
    return fmt::format("export/{}.{}", job.spec->name, extension_of(format));
}

// Averaged to at most `samples` along the longer side. Cells stay square.
Terrain reduced(const Terrain& terrain, int samples) {
    Terrain result{at_most(terrain.heights, samples), terrain.spacing, {}, {}, {}};
    result.spacing *= double(terrain.heights.width()) / result.heights.width();
    return result;
}

Json json_of(const StoredHeights& stored, const Terrain& land, HeightFormat format) {
    const Field<float>& heights = land.heights;
    const auto metres = [&](double value) {
        return stored.offset + stored.scale * value;
    };
    Json json = {
        {"format", name_of(format)},
        {"type", stored.type},
        {"samples", {heights.width(), heights.height()}},
        {"spacing", land.spacing},
        {"extent", {land.width(), land.depth()}},
        {"rows", stored.from_south ? "from south to north" : "from north to south"},
        {"columns", "from west to east"},
        {"axes", axes("x", "y", "z")},
        {"origin", "the south-western corner of the extent, at height 0"},
        {"samples_stand_at", "the centres of cells"},
        {"metres", {{"offset", stored.offset}, {"scale", stored.scale}}},
        {"range",
         {{"values", {stored.lowest, stored.highest}},
          {"metres", {metres(stored.lowest), metres(stored.highest)}}}}};
    if (format == HeightFormat::kRaw16 || format == HeightFormat::kRaw32) {
        json["byte_order"] = "little-endian";
        json["header_bytes"] = 0;
    }
    return json;
}

StepResult make_heights(const Job& job, HeightFormat format, int samples) {
    const Terrain land = reduced(*job.land.finished(), samples);
    const std::string file = file_name(job, format);
    make_folder(job.folder / "export");
    Metadata metadata = job.metadata();
    metadata["cydonia:spacing"] = fmt::format("{}", land.spacing);
    const StoredHeights stored = write_heights(job.folder / file, land, format, metadata);
    return with_sidecar(job, file, json_of(stored, land, format));
}

void say_what_it_is(const Json& result, const Job& job, HeightFormat format) {
    const Json& metres = result.at("metres");
    const Json& range = result.at("range").at("metres");
    const bool plain = metres.at("scale") == 1.0 && metres.at("offset") == 0.0;
    job.progress.note(
        fmt::format("{}: {} x {} samples {:g} m apart, {:.2f} to {:.2f} m, rows {}; {}",
                    file_name(job, format), result.at("samples")[0].get<int>(),
                    result.at("samples")[1].get<int>(),
                    result.at("spacing").get<double>(), range[0].get<double>(),
                    range[1].get<double>(), result.at("rows").get<std::string>(),
                    plain ? "values are metres"
                          : fmt::format("metres = {:g} + {:g} * value",
                                        metres.at("offset").get<double>(),
                                        metres.at("scale").get<double>())));
}

}  // namespace

Step heights_step(const Job& job) {
    const auto format = std::get<HeightFormat>(job.request.export_as->format);
    const int most = format == HeightFormat::kXyz ? kMostXyzSamples : kLargestSide;
    const int by_default = std::max(job.land.width(), job.land.height());
    const int samples = samples_of(*job.request.export_as, by_default, most);
    const auto key = [&job, format, samples] {
        return KeyBuilder("heights")
            .add(job.program)
            .add(job.land.key())
            .add(job.spec->name)
            .add(name_of(format))
            .add(samples)
            .key();
    };
    return {
        .id = export_file_id(job),
        .memory = memory::of_heights(job.cells(), samples, format == HeightFormat::kXyz),
        .key = key,
        .run = [&job, format,
                samples](Graph&) { return make_heights(job, format, samples); },
        .gate = [&job,
                 format](const Json& result) { say_what_it_is(result, job, format); }};
}

}  // namespace cydonia
