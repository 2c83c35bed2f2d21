#include "app/export/export.h"

#include "field/error.h"
#include "field/files.h"

namespace cydonia {

std::string_view name_of(const ExportFormat& format) {
    if (const auto* mesh = std::get_if<MeshFormat>(&format)) return name_of(*mesh);
    if (const auto* heights = std::get_if<HeightFormat>(&format))
        return name_of(*heights);
    return "glb";
}

const std::map<std::string, ExportFormat>& export_formats() {
    static const std::map<std::string, ExportFormat> formats = [] {
        std::map<std::string, ExportFormat> all;
        const auto add = [&](const ExportFormat& f) { all[std::string(name_of(f))] = f; };
        for (const MeshFormat f : {MeshFormat::kStl, MeshFormat::kObj, MeshFormat::kPly})
            add(f);
        add(GltfFormat{});
        for (const HeightFormat f :
             {HeightFormat::kTer, HeightFormat::kTif, HeightFormat::kPng16,
              HeightFormat::kRaw16, HeightFormat::kRaw32, HeightFormat::kExr,
              HeightFormat::kXyz})
            add(f);
        return all;
    }();
    return formats;
}

std::string export_file_id(const Job& job) {
    return "export " + std::string(name_of(job.request.export_as->format));
}

Step export_file_step(const Job& job) {
    const ExportFormat& format = job.request.export_as->format;
    if (std::holds_alternative<MeshFormat>(format)) return solid_step(job);
    if (std::holds_alternative<HeightFormat>(format)) return heights_step(job);
    return gltf_step(job);
}

Json axes(const char* east, const char* north, const char* up) {
    return {{"east", east}, {"north", north}, {"up", up}};
}

StepResult with_sidecar(const Job& job, const std::string& file, Json what) {
    Json all = {{"file", std::filesystem::path(file).filename().string()},
                {"scene", job.spec->name},
                {"title", job.spec->title},
                {"seed", job.spec->seed},
                {"cydonia", kVersion}};
    all.update(what);
    write_text(job.folder / (file + ".json"), all.dump(2) + "\n");
    return {{file, file + ".json"}, std::move(what)};
}

int samples_of(const ExportRequest& asked, int by_default, int most) {
    const int samples = asked.samples.value_or(by_default);
    if (samples < 2 || samples > most)
        throw bad_request("samples: {} is not between 2 and {}", samples, most);
    return samples;
}

}  // namespace cydonia
