#include "synth/pareidolia/image.h"

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "synth/pareidolia/light_frame.h"
#include "synth/pareidolia/target.h"

namespace cydonia::pareidolia {
namespace {

// The elevations among which "auto" chooses. A lower sun blurs the image by its own
// width; a higher one needs steep land.
constexpr double kLowest = radians(8.0), kHighest = radians(35.0);

void check_counts(const Options& options) {
    const std::size_t images = options.images.size();
    if (options.solver == Solver::kFeatures && images != 1)
        throw bad_request(
            "solver = \"features\" takes exactly one image, this stage has {}", images);
    if (images < 1 || images > std::size_t{kMostImages})
        throw bad_request("a stage takes 1 to {} images, this one has {}", kMostImages,
                          images);
}

void check_sun(const ImageOptions& options) {
    const double elevation = options.elevation.value_or(kLowest);
    if (!(elevation > 0.0 && elevation < radians(89.9)))
        throw bad_request(
            "sun: elevation {} degrees casts no shadow: it must be above 0 and below 90",
            degrees(elevation));
}

// The image at a size that is the same for every number of samples, so that the search
// for a sun finds the same one.
struct Small {
    Field<std::uint8_t> target;
    double spacing;  // metres
};
Small small_target(const ImageOptions& options, const Picture& picture,
                   const Terrain& terrain, const Field<std::uint8_t>& target) {
    constexpr int kLonger = 256;
    const double longer = std::max(terrain.width(), terrain.depth());
    const auto cells = [&](double metres) {
        return std::max(1, static_cast<int>(std::lround(kLonger * metres / longer)));
    };
    Small small{
        silent_target(options, picture, cells(terrain.width()), cells(terrain.depth())),
        longer / kLonger};
    if (std::count(small.target.begin(), small.target.end(), 1) > 0) return small;
    return {target, terrain.spacing};  // too thin to be visible at that size
}

// The length of the longest shadow over the ground, in metres.
double longest_shadow(const Small& small, double azimuth) {
    const LightFrame frame =
        light_frame(small.target.width(), small.target.height(), azimuth, 1);
    int longest = 0;
    for (const Run& run : runs_of(rotated(small.target, frame)))
        longest = std::max(longest, run.past - run.first);
    return longest * small.spacing;
}

// The height in metres that crests may take when the scene sets no budget: the relief of
// the base without a few extreme cells, or on flat land a share of its size.
double natural_budget(const Terrain& terrain) {
    std::vector<float> heights(terrain.heights.begin(), terrain.heights.end());
    const auto at = [&](double share) {
        const auto place = heights.begin() + static_cast<std::ptrdiff_t>(
                                                 share * double(heights.size() - 1));
        std::nth_element(heights.begin(), place, heights.end());
        return double(*place);
    };
    const double relief = at(0.99) - at(0.01);
    return std::max(relief, std::max(terrain.width(), terrain.depth()) / 20.0);
}

double half_degree_below(double angle) {
    return radians(std::floor(2.0 * degrees(angle) + 1e-9) / 2.0);
}

// How much the land falls in the direction of the light of a sun at `azimuth`: the
// covariance of depth and distance along the light.
double fall_along(const Terrain& terrain, double azimuth) {
    const Field<float>& heights = terrain.heights;
    const double dx = -std::sin(azimuth), dy = std::cos(azimuth);
    const double x0 = (heights.width() - 1) / 2.0, y0 = (heights.height() - 1) / 2.0;
    double fall = 0.0;
    for (int y = 0; y < heights.height(); ++y)
        for (int x = 0; x < heights.width(); ++x)
            fall -= heights(x, y) * ((x - x0) * dx + (y - y0) * dy);
    return fall;
}

// Along an axis of the grid the rows of light are rows of heights, so that the solver's
// inequalities are exact. Of the two axes this takes the one whose longest shadow is
// shorter, with the light in the direction in which the land already falls.
double azimuth_on_axis(const Small& small, const Terrain& terrain) {
    const double east = radians(90.0);
    const double azimuth =
        longest_shadow(small, 0.0) <= longest_shadow(small, east) ? 0.0 : east;
    const double opposite = azimuth + radians(180.0);
    return fall_along(terrain, azimuth) >= fall_along(terrain, opposite) ? azimuth
                                                                         : opposite;
}

double chosen_azimuth(Solver solver, const Small& small, const Terrain& terrain,
                      const std::string& name, Progress& progress) {
    const bool on_axis = solver == Solver::kConstrained;
    const double azimuth =
        on_axis ? azimuth_on_axis(small, terrain) : shortest_azimuth(small.target);
    progress.note(fmt::format(
        "{}: the sun stands at azimuth {:.0f} degrees, where the longest shadow is "
        "shortest{}",
        name, degrees(azimuth), on_axis ? " of those along the grid" : ""));
    return azimuth;
}

double chosen_elevation(double shadow, double budget, const std::string& name,
                        Progress& progress) {
    const double fitting = std::atan(budget / shadow);
    const double elevation = std::clamp(half_degree_below(fitting), kLowest, kHighest);
    progress.note(fmt::format(
        "{}: the sun stands {:.1f} degrees high, where the longest shadow, {:.0f} m, "
        "falls {:.0f} m of a height budget of {:.0f} m",
        name, degrees(elevation), shadow, shadow * std::tan(elevation), budget));
    return elevation;
}

void check_budget(double shadow, double elevation, double budget,
                  const std::string& name) {
    const double needed = shadow * std::tan(elevation);
    if (needed <= budget) return;
    throw bad_request(
        "{}: its longest shadow, {:.0f} m, needs {:.0f} m under a sun {:.1f} degrees "
        "high and height_budget is {:.0f} m: raise it, make the image smaller by scale, "
        "or lower the sun to {:.1f} degrees",
        name, shadow, std::ceil(needed), degrees(elevation), budget,
        std::floor(10.0 * degrees(std::atan(budget / shadow))) / 10.0);
}

// Cells on the edge of the land where light enters have no room before them for a caster.
void say_edge(const ShadowImage& image, Progress& progress) {
    const double east = std::sin(image.sun.azimuth), north = std::cos(image.sun.azimuth);
    const int right = image.target.width() - 1, bottom = image.target.height() - 1;
    std::ptrdiff_t cells = 0;
    for (int y = 0; y <= bottom; ++y)
        for (int x = 0; x <= right; ++x) {
            const bool sunny = (x == right && east > 0.02) || (x == 0 && east < -0.02) ||
                               (y == 0 && north > 0.02) || (y == bottom && north < -0.02);
            cells += sunny && image.target(x, y);
        }
    if (cells > 0)
        progress.note(fmt::format(
            "{}: {} cells of shadow touch the edge of the land where the light comes in: "
            "nothing can cast them; move the image or make it smaller",
            image.name, cells));
}

ShadowImage shadow_image(const Options& stage, const ImageOptions& options,
                         const std::string& name, const Terrain& terrain,
                         Progress& progress) {
    const std::optional<double>& height_budget = stage.height_budget;
    check_sun(options);
    ShadowImage image;
    image.name = name;
    image.min_iou = options.min_iou;
    const Picture picture = picture_of(options, progress);
    image.target = shadow_target(options, picture, terrain.heights.width(),
                                 terrain.heights.height(), progress);

    const bool looks = !options.azimuth || !options.elevation || height_budget;
    const Small small =
        looks ? small_target(options, picture, terrain, image.target) : Small{};
    image.sun.azimuth =
        options.azimuth ? *options.azimuth
                        : chosen_azimuth(stage.solver, small, terrain, name, progress);
    const double shadow = looks ? longest_shadow(small, image.sun.azimuth) : 0.0;
    image.sun.elevation =
        options.elevation
            ? *options.elevation
            : chosen_elevation(shadow,
                               height_budget ? *height_budget : natural_budget(terrain),
                               name, progress);
    if (height_budget) check_budget(shadow, image.sun.elevation, *height_budget, name);
    say_edge(image, progress);
    return image;
}

}  // namespace

std::vector<ShadowImage> shadow_images(const Options& options, const Terrain& terrain,
                                       Progress& progress) {
    check_counts(options);
    const std::vector<std::string> names = image_names(options.images);
    std::vector<ShadowImage> images;
    for (std::size_t i = 0; i < names.size(); ++i)
        images.push_back(
            shadow_image(options, options.images[i], names[i], terrain, progress));
    return images;
}

}  // namespace cydonia::pareidolia
