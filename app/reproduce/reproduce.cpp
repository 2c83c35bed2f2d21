#include "app/reproduce/reproduce.h"

#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <map>

#include "app/pipeline/pipeline.h"
#include "app/reproduce/compare.h"
#include "app/reproduce/manifest_file.h"
#include "field/error.h"
#include "field/files.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

// Where to make the files again: not in the folder that they are compared with.
fs::path folder_for(const ManifestFile& manifest, const std::optional<fs::path>& asked) {
    if (asked) {
        if (fs::weakly_canonical(*asked) == fs::weakly_canonical(manifest.folder))
            throw bad_request("-o {}: the manifest's own folder; name another one",
                              asked->string());
        return *asked;
    }
    std::string name = (fs::temp_directory_path() / "cydonia-again-XXXXXX").string();
    if (!mkdtemp(name.data())) throw failure("cannot make a folder such as {}", name);
    return name;
}

// POV-Ray's radiosity differs from run to run (docs/rendering.md).
bool is_jittered(const ManifestFile& manifest, const std::string& file) {
    const fs::path top = *fs::path(file).begin();
    return manifest.request.quality != render::Quality::kDraft &&
           !manifest.request.preview && top != "masks" && top != "shadow" &&
           file.find('/') != file.npos;
}

// Prints the table and returns how many files differ.
std::size_t print_comparison(const ManifestFile& manifest, const fs::path& folder) {
    std::map<std::string, std::size_t> counts;
    std::size_t longest = 4, failures = 0;
    for (const auto& output : manifest.outputs)
        longest = std::max(longest, output.file.size());
    for (const auto& output : manifest.outputs) {
        const Comparison comparison =
            compare(output, manifest.folder / output.file, folder / output.file,
                    is_jittered(manifest, output.file));
        fmt::print("  {:<{}}  {}\n", output.file, longest, text_of(comparison));
        ++counts[text_of({comparison.likeness, ""})];
        failures += is_failure(comparison.likeness);
    }
    std::string summary;
    for (const auto& [text, count] : counts)
        summary += fmt::format("{}{} {}", summary.empty() ? "" : ", ", count, text);
    fmt::print("{} files: {}\n", manifest.outputs.size(), summary);
    return failures;
}

}  // namespace

void reproduce(const fs::path& file, const std::optional<fs::path>& output,
               Console& console) {
    const ManifestFile manifest = read_manifest(file);
    for (const std::string& note : check_inputs(manifest)) console.warn(note);
    if (manifest.goals.empty() || manifest.outputs.empty())
        throw bad_request("{}: nothing was finished that could be made again",
                          file.string());

    Request request = manifest.request;
    request.output = folder_for(manifest, output);
    for (const Goal goal : manifest.goals) {
        Progress& progress = console;
        make(request, goal, progress);
    }
    console.finish();
    const std::size_t different = print_comparison(manifest, request.output);
    if (different > 0)
        throw Error(
            ExitCode::kCheckFellShort,
            fmt::format("{} of {} files are not what they were; the new ones are "
                        "in {}",
                        different, manifest.outputs.size(), request.output.string()));
    if (!output) fs::remove_all(request.output);
}

}  // namespace cydonia
