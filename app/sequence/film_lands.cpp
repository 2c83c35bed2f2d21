#include "app/sequence/film_lands.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

#include "app/interrupt.h"
#include "field/files.h"
#include "render/pov/scene.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

// The lines of [render] that the files of a land depend on. The others are about what a
// single frame draws.
std::string land_text(const std::string& render_text) {
    constexpr std::array<std::string_view, 8> kOfFrames = {
        "sun", "camera", "sky", "haze", "water", "colour", "passes", "thing"};
    std::string text;
    for (std::size_t begin = 0; begin < render_text.size();) {
        const std::size_t end =
            std::min(render_text.find('\n', begin), render_text.size());
        const std::string_view line =
            std::string_view(render_text).substr(begin, end - begin);
        const std::string_view table = line.substr(0, line.find_first_of(".[ "));
        if (std::ranges::find(kOfFrames, table) == kOfFrames.end())
            text.append(line).push_back('\n');
        begin = end + 1;
    }
    return text;
}

Key key_of(const LandStore& land, const config::SceneSpec& scene) {
    return KeyBuilder("land of a frame")
        .add(land.drawn_key())
        .add(land_text(scene.render_text))
        .key();
}

// .cache/lands/all, or .cache/lands/0-7 if other processes trace other frames.
fs::path folder_of(const Job& job) {
    const fs::path lands = job.folder / ".cache" / "lands";
    if (!job.request.trace_only) return lands / "all";
    return lands /
           fmt::format("{}-{}", job.request.frames->first, job.request.frames->last);
}

// Stops if the user interrupts and passes warnings on. The rest is not shown, because the
// bar on the screen is that of the sequence.
class Silence final : public Progress {
  public:
    explicit Silence(Progress& all) : all_(all) {}
    void step(std::string_view) override {}
    void report(double) override {
        if (interrupt_signal() != 0) throw Interrupted{};
    }
    void note(std::string_view) override {}
    void warn(std::string_view sentence) override { all_.warn(sentence); }

  private:
    Progress& all_;
};

}  // namespace

FilmLands::FilmLands(const Job& job)
    : job_(job), own_(key_of(job.land, *job.spec)), folder_(folder_of(job)) {}

void FilmLands::remove_leftovers() const {
    std::error_code none;
    fs::remove_all(job_.request.trace_only ? folder_ : folder_.parent_path(), none);
}

FrameLand FilmLands::of(const SequenceFrame& frame) {
    if (!frame.scene) return land_of_stills(job_);
    Silence silence(job_.progress);
    const Key key = key_of(job_.land_of(frame.scene, silence), *frame.scene);
    if (key == own_) return land_of_stills(job_);
    return {key, [this, key, scene = frame.scene] { return site(key, scene); }, true};
}

std::shared_ptr<const Site> FilmLands::site(
    Key key, std::shared_ptr<const config::SceneSpec> scene) {
    const std::scoped_lock lock(mutex_);
    if (auto held = sites_[key].lock()) return latest_ = std::move(held);
    latest_.reset();
    Silence silence(job_.progress);
    const LandStore land = job_.land_of(scene, silence);
    const auto remove = [](const Site* site) {
        std::error_code none;
        if (!site->pov.empty()) fs::remove_all(site->pov, none);
        delete site;
    };
    const fs::path pov = job_.request.preview ? fs::path() : folder_ / hex(key);
    const auto maps = std::make_shared<render::LandMaps>();
    const std::shared_ptr<const Site> site(
        new Site{land.drawn(), [maps] { return maps; }, pov}, remove);
    if (!pov.empty()) {
        make_folder(pov);
        *maps =
            render::land_maps(*site->terrain, scene->render.ground, job_.request.quality);
        render::write_pov_assets(pov, *site->terrain, *maps);
        maps->ground.albedo = {};
    }
    sites_[key] = site;
    return latest_ = site;  // the next frame may want it too
}

}  // namespace cydonia
