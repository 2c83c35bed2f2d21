#include "app/sequence/sites.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

#include "app/interrupt.h"
#include "app/pipeline/cache.h"
#include "field/files.h"
#include "render/pov/scene.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

constexpr const char* kFolder = "land-";

// The lines of [render] that say what the land's own files hold: all but those that say
// what a single shot draws.
std::string land_text(const std::string& render_text) {
    constexpr std::array<std::string_view, 8> kOfShots = {
        "sun", "camera", "sky", "haze", "water", "colour", "passes", "thing"};
    std::string text;
    for (std::size_t begin = 0; begin < render_text.size();) {
        const std::size_t end =
            std::min(render_text.find('\n', begin), render_text.size());
        const std::string_view line =
            std::string_view(render_text).substr(begin, end - begin);
        const std::string_view table = line.substr(0, line.find_first_of(".[ "));
        if (std::ranges::find(kOfShots, table) == kOfShots.end())
            text.append(line).push_back('\n');
        begin = end + 1;
    }
    return text;
}

std::uint64_t key_of(const Land& land, const config::SceneSpec& scene) {
    return hash_text(
        fmt::format("{:016x}\n{}", land.drawn_key(), land_text(scene.render_text)));
}

// Heeds an interruption and says nothing: the sequence is what the user waits for.
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

struct Sites::Own {
    Own(const fs::path& folder, Terrain drawn) : terrain(std::move(drawn)), pov(folder) {}
    ~Own() {
        std::error_code none;
        fs::remove_all(pov, none);
    }
    Own(const Own&) = delete;
    Own& operator=(const Own&) = delete;

    Terrain terrain;
    fs::path pov;
    Site site{terrain, pov};
};

Sites::Sites(Job& job) : job_(job), jobs_own_(key_of(job.land, job.spec)) {}

void Sites::remove_leftovers() {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(job_.folder / "pov", none))
        if (entry.path().filename().string().starts_with(folder_prefix()))
            fs::remove_all(entry.path(), none);
}

std::string Sites::folder_prefix() const {
    if (!job_.request.trace_only) return kFolder;
    return fmt::format("{}{}-{}-", kFolder, job_.request.frames->first,
                       job_.request.frames->last);
}

void Sites::choose(const Shot& shot, FrameOf& frame) {
    if (!shot.scene) return;
    frame.scene = shot.scene.get();
    Silence silence(job_.progress);
    const std::uint64_t key = key_of(job_.land_of(*shot.scene, silence), *shot.scene);
    if (key == jobs_own_) return;
    frame.land = key;
    frame.site = [this, key, &scene = *shot.scene] { return at(key, scene); };
}

std::shared_ptr<const Site> Sites::at(std::uint64_t key, const config::SceneSpec& scene) {
    const std::scoped_lock lock(mutex_);
    std::shared_ptr<const Own> own = made_[key].lock();
    if (!own) {
        Silence silence(job_.progress);
        Land land = job_.land_of(scene, silence);
        const fs::path folder =
            job_.folder / "pov" / fmt::format("{}{:016x}", folder_prefix(), key);
        own = std::make_shared<const Own>(folder, land.drawn());
        if (!job_.request.preview) {  // of POV-Ray
            make_folder(folder);
            render::write_pov_assets(folder, own->terrain,
                                     render::land_maps(own->terrain, scene.render.ground,
                                                       job_.request.quality));
        }
        made_[key] = own;
    }
    latest_ = own;  // the next frame may want it
    return {own, &own->site};
}

}  // namespace cydonia
