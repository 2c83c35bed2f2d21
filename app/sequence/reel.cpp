#include "app/sequence/reel.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "app/gallery/contact_sheet.h"
#include "app/sequence/share.h"
#include "field/files.h"
#include "render/frames/video.h"

namespace cydonia {
namespace {

constexpr std::size_t kSheetFrames = 48;  // at most, evenly chosen
constexpr std::size_t kSheetBytes = 400000;
constexpr std::array<const char*, 3> kVideos = {".mp4", ".webp", ".gif"};

// A video of numbered PNG files.
struct Reel {
    std::string name;
    std::vector<std::string> frames;  // relative to the output folder
};

std::string reel_name(const std::string& sequence, const Job& job) {
    if (!job.request.preview) return sequence;
    return sequence + '-' + std::string(name_of(*job.request.preview));
}

Reel reel_of(const Job& job, const Sequence& sequence) {
    Reel reel{reel_name(sequence.name, job), {}};
    for (std::size_t i = 0; i < sequence.frames.size(); ++i)
        reel.frames.push_back("frames/" + frame_name(reel.name, static_cast<int>(i)) +
                              ".png");
    return reel;
}

void write_sheet(const Job& job, const Reel& reel, const std::string& file) {
    const std::size_t tiles = std::min(reel.frames.size(), kSheetFrames);
    std::vector<Tile> sheet;
    for (std::size_t i = 0; i < tiles; ++i) {
        const std::string& frame = reel.frames[i * reel.frames.size() / tiles];
        const Field<Rgba8> picture = read_rgba(open_source(job.folder / frame));
        Tile tile{std::filesystem::path(frame).stem().string(),
                  Field<Rgb8>(picture.width(), picture.height())};
        std::ranges::transform(picture, tile.picture.begin(), [](const Rgba8& pixel) {
            return Rgb8{pixel[0], pixel[1], pixel[2]};
        });
        sheet.push_back(std::move(tile));
    }
    write_text(job.folder / file, jpeg_within(contact_sheet(sheet), kSheetBytes));
}

}  // namespace

StepResult encode(const Sequence& sequence, const Job& job) {
    const Reel reel = reel_of(job, sequence);
    const render::Film film{
        job.folder / "frames", reel.name,      static_cast<int>(reel.frames.size()),
        sequence.rate,         sequence.still, sequence.hold};
    StepResult made{files_of_reel(sequence.name, job)};
    write_sheet(job, reel, made.outputs.front());
    // A small video keeps less than one core busy, so all are encoded at once.
    Share share(kVideos.size(), job.progress);
    tbb::parallel_for(std::size_t{0}, kVideos.size(), [&](std::size_t i) {
        FrameProgress progress(i, 1.0, share);
        render::encode_video(film, job.folder / "frames" / (reel.name + kVideos[i]),
                             progress);
    });
    return made;
}

std::vector<std::string> files_of_reel(const std::string& sequence, const Job& job) {
    const std::string stem = "frames/" + reel_name(sequence, job);
    std::vector<std::string> files{stem + ".jpg"};
    for (const char* extension : kVideos) files.push_back(stem + extension);
    return files;
}

}  // namespace cydonia
