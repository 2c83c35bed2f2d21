#include "render/colour/colour.h"

#include <OpenColorIO/OpenColorIO.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "field/data.h"
#include "tests/field/temporary_folder.h"
#include "tests/render/environment.h"

namespace OCIO = OCIO_NAMESPACE;

namespace cydonia::render {
namespace {

void expect_near(const Rgb& value, const Rgb& truth, double tolerance) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(value[i], truth[i], tolerance) << i;
}

ColourOptions with_config(const std::filesystem::path& file) {
    ColourOptions options;
    options.config = open_source(file);
    return options;
}

OCIO::ConstConfigRcPtr shipped_config() {
    return OCIO::Config::CreateFromFile(data_file("ocio/config.ocio").c_str());
}

// OpenColorIO alone, without anything of ours.
Rgb shown_by_ocio(Rgb acescg, const char* display, const char* view) {
    shipped_config()
        ->getProcessor("ACEScg", display, view, OCIO::TRANSFORM_DIR_FORWARD)
        ->getDefaultCPUProcessor()
        ->applyRGB(acescg.data());
    return acescg;
}

// No aliases of ours, only linear Rec.709 by an older name; and nothing to see it by.
std::string small_config(const std::string& linear, const std::string& view_space) {
    return "ocio_profile_version: 1\n"
           "search_path: luts\n"
           "roles: {default: raw, scene_linear: " +
           linear +
           "}\n"
           "displays:\n"
           "  tv:\n"
           "    - !<View> {name: film, colorspace: " +
           view_space +
           "}\n"
           "    - !<View> {name: plain, colorspace: raw}\n"
           "colorspaces:\n"
           "  - !<ColorSpace> {name: raw, isdata: true}\n"
           "  - !<ColorSpace> {name: " +
           linear +
           "}\n"
           "  - !<ColorSpace>\n"
           "    name: halved\n"
           "    from_reference: !<MatrixTransform> {matrix: [0.5, 0, 0, 0, 0, 0.5, 0, 0, "
           "0, 0, 0.5, 0, 0, 0, 0, 1]}\n"
           "  - !<ColorSpace>\n"
           "    name: tabled\n"
           "    from_reference: !<FileTransform> {src: film.cube}\n";
}

class Colour : public testing::Test {
  protected:
    TemporaryFolder folder;
    Environment no_ocio{"OCIO", nullptr};
};

// The matrix as colour-science and the ACES repository print it.
TEST_F(Colour, PrimariesAndWhiteOfRec709InAcesCg) {
    expect_near(acescg_from_rec709({1, 0, 0}), {0.613097f, 0.070194f, 0.020616f}, 1e-4);
    expect_near(acescg_from_rec709({0, 1, 0}), {0.339523f, 0.916354f, 0.109570f}, 1e-4);
    expect_near(acescg_from_rec709({0, 0, 1}), {0.047379f, 0.013452f, 0.869815f}, 1e-4);
    expect_near(acescg_from_rec709({1, 1, 1}), {1, 1, 1}, 1e-6);
}

TEST_F(Colour, ShippedConfigAgreesWithTheMatrix) {
    const auto processor = shipped_config()
                               ->getProcessor("Linear Rec.709 (sRGB)", "ACEScg")
                               ->getDefaultCPUProcessor();
    for (const Rgb& rec709 : {Rgb{1, 0, 0}, Rgb{0, 1, 0}, Rgb{0, 0, 1}, Rgb{3, -1, 2}}) {
        Rgb truth = rec709;
        processor->applyRGB(truth.data());
        expect_near(acescg_from_rec709(rec709), truth, 1e-5);
    }
}

// One conversion each way: what goes there and back is what it was, below nothing and
// above white too.
TEST_F(Colour, ThereAndBack) {
    for (const Rgb& colour : {Rgb{1, 1, 1}, Rgb{0.18f, 0.18f, 0.18f},
                              Rgb{-0.2f, 3, 0.01f}, Rgb{40, -7, 0.5f}}) {
        expect_near(rec709_from_acescg(acescg_from_rec709(colour)), colour, 1e-5);
        expect_near(acescg_from_rec709(rec709_from_acescg(colour)), colour, 1e-5);
    }
}

// A green that Rec.709 has no paint for is negative red there, and comes back.
TEST_F(Colour, NegativesSurvive) {
    const Rgb green = rec709_from_acescg({0, 1, 0});
    EXPECT_LT(green[0], -0.5f);
    expect_near(acescg_from_rec709(green), {0, 1, 0}, 1e-6);
}

TEST_F(Colour, WhiteHasTheLuminanceOne) { EXPECT_NEAR(luminance({1, 1, 1}), 1.0, 1e-6); }

TEST_F(Colour, DefaultsAreSrgbThroughAces) {
    const Display display({});
    EXPECT_EQ(display.display(), "sRGB");
    EXPECT_EQ(display.view(), "ACES 1.0 - SDR Video");
}

TEST_F(Colour, MiddleGreyIsShownAsByOcio) {
    const Rgb grey = Display({}).shown(Rgb{0.18f, 0.18f, 0.18f});
    expect_near(
        grey, shown_by_ocio({0.18f, 0.18f, 0.18f}, "sRGB", "ACES 1.0 - SDR Video"), 1e-6);
    // ACES puts it at a tenth of the display's light.
    EXPECT_NEAR(grey[0], 1.055 * std::pow(0.1, 1 / 2.4) - 0.055, 0.01);
}

constexpr const char* kDisplays[] = {"sRGB", "Rec.1886 Rec.709", "P3-D65", "Display P3"};

// The light a display makes of a value, 1 its white.
double light_of(double value, const std::string& display) {
    if (display == "Rec.1886 Rec.709") return std::pow(value, 2.4);
    if (display == "P3-D65") return std::pow(value, 2.6);
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

ColourOptions seen_as(const char* display, const char* view) {
    ColourOptions options;
    options.display = display;
    options.view = view;
    return options;
}

TEST_F(Colour, WhiteIsWhiteOnEveryDisplay) {
    for (const char* display : kDisplays)
        expect_near(Display(seen_as(display, "Un-tone-mapped")).shown(Rgb{1, 1, 1}),
                    {1, 1, 1}, 1e-3);
}

// Grey stays grey, and ACES shows middle grey with a tenth of the display's light.
TEST_F(Colour, MiddleGreyIsATenthOnEveryDisplay) {
    for (const char* display : kDisplays) {
        const Rgb grey = Display(seen_as(display, "ACES 1.0 - SDR Video"))
                             .shown(Rgb{0.18f, 0.18f, 0.18f});
        EXPECT_NEAR(light_of(grey[1], display), 0.1, 0.005) << display;
        expect_near(grey, {grey[1], grey[1], grey[1]}, 1e-3);
        const Rgb plain =
            Display(seen_as(display, "Un-tone-mapped")).shown(Rgb{0.18f, 0.18f, 0.18f});
        EXPECT_NEAR(light_of(plain[1], display), 0.18, 1e-3) << display;
    }
}

// XYZ of P3's primaries for D65, SMPTE RP 431-2 and EG 432-1; of Rec.709's, IEC
// 61966-2-1.
TEST_F(Colour, DisplaysHaveTheirPublishedPrimaries) {
    const Rgb p3[] = {{0.486571f, 0.228975f, 0.0f},
                      {0.265668f, 0.691739f, 0.045113f},
                      {0.198217f, 0.079287f, 1.043944f}};
    const Rgb rec709[] = {{0.412391f, 0.212639f, 0.019331f},
                          {0.357584f, 0.715169f, 0.119195f},
                          {0.180481f, 0.072192f, 0.950532f}};
    for (const char* display : kDisplays)
        for (int i = 0; i < 3; ++i) {
            Rgb acescg =
                std::string(display).find("P3") == std::string::npos ? rec709[i] : p3[i];
            shipped_config()
                ->getProcessor("CIE-XYZ-D65", display, "Un-tone-mapped",
                               OCIO::TRANSFORM_DIR_FORWARD)
                ->getDefaultCPUProcessor()
                ->applyRGB(acescg.data());
            for (int k = 0; k < 3; ++k)
                EXPECT_NEAR(light_of(std::abs(acescg[k]), display), k == i, 1e-3)
                    << display << " " << i << " " << k;
        }
}

// A colour that only the other gamut has: P3's red is out of Rec.709's reach.
TEST_F(Colour, DisplayP3ReachesFartherThanSrgb) {
    const Rgb red = acescg_from_rec709({1, 0, 0});
    EXPECT_NEAR(Display(seen_as("sRGB", "Un-tone-mapped")).shown(red)[0], 1.0, 1e-3);
    const Rgb inside = Display(seen_as("Display P3", "Un-tone-mapped")).shown(red);
    // As colour.js and Apple's ColorSync print sRGB's red in Display P3.
    expect_near(inside, {0.9175f, 0.2003f, 0.1386f}, 1e-3);
}

TEST_F(Colour, EveryDisplayHasEveryView) {
    for (const char* display : kDisplays)
        for (const char* view : {"ACES 1.0 - SDR Video", "Un-tone-mapped", "Raw"}) {
            ColourOptions options;
            options.display = display;
            options.view = view;
            expect_near(Display(options).shown(Rgb{0.3f, 0.1f, 0.05f}),
                        shown_by_ocio({0.3f, 0.1f, 0.05f}, display, view), 1e-6);
        }
}

TEST_F(Colour, PicturesAreRoundedToEightBitsAndCutOff) {
    ColourOptions options;
    options.view = "Raw";
    Field<Rgb> picture(2, 2);
    picture(0, 0) = {0.0f, 0.5f, 1.0f};
    picture(1, 0) = {-1.0f, 7.0f, 0.1f};
    picture(0, 1) = {0.00195f, 0.00197f, 0.999f};
    const Field<Rgb8> bytes = Display(options).shown(picture);
    EXPECT_EQ(bytes(0, 0), (Rgb8{0, 128, 255}));
    EXPECT_EQ(bytes(1, 0), (Rgb8{0, 255, 26}));
    EXPECT_EQ(bytes(0, 1), (Rgb8{0, 1, 255}));
}

TEST_F(Colour, ConfigOfTheEnvironmentAndOverItTheScenes) {
    const auto halved =
        folder.with("halved.ocio", small_config("Linear Rec.709", "halved"));
    const auto raw = folder.with("raw.ocio", small_config("Linear Rec.709", "raw"));
    const Environment ocio("OCIO", halved.c_str());
    expect_near(Display({}).shown(Rgb{1, 1, 1}), {0.5f, 0.5f, 0.5f}, 1e-5);
    EXPECT_EQ(Display({}).display(), "tv");
    expect_near(Display(with_config(raw)).shown(Rgb{1, 1, 1}), {1, 1, 1}, 1e-5);
}

TEST_F(Colour, ConfigThatKnowsOnlyRec709GetsRec709) {
    const auto file =
        folder.with("config.ocio", small_config("Linear Rec.709", "halved"));
    expect_near(Display(with_config(file)).shown(acescg_from_rec709({0.8f, 0.2f, 0.1f})),
                {0.4f, 0.1f, 0.05f}, 1e-5);
}

// A config of version 2 whose only bridge to ours is the role made for it.
TEST_F(Colour, ConfigThatIsReachedByInterchange) {
    const auto file = folder.with("config.ocio",
                                  "ocio_profile_version: 2\n"
                                  "roles: {default: raw, aces_interchange: exchange}\n"
                                  "displays:\n"
                                  "  tv:\n"
                                  "    - !<View> {name: plain, colorspace: exchange}\n"
                                  "colorspaces:\n"
                                  "  - !<ColorSpace> {name: raw, isdata: true}\n"
                                  "  - !<ColorSpace> {name: exchange}\n");
    // AP1's red in AP0, as S-2014-004 prints it.
    expect_near(Display(with_config(file)).shown(Rgb{1, 0, 0}),
                {0.695452f, 0.044794f, -0.005526f}, 1e-4);
}

TEST_F(Colour, ConfigWithoutASpaceForOurs) {
    const auto file = folder.with("config.ocio", small_config("linearish", "halved"));
    expect_error(ExitCode::kBadRequest, "has no colour space named ACEScg or lin_rec709",
                 [&] { Display{with_config(file)}; });
}

TEST_F(Colour, UnknownDisplay) {
    ColourOptions options;
    options.display = "IMAX";
    expect_error(
        ExitCode::kBadRequest,
        "the display 'IMAX' is unknown; there is: sRGB, Rec.1886 Rec.709, P3-D65, "
        "Display P3",
        [&] { Display{options}; });
}

TEST_F(Colour, UnknownView) {
    ColourOptions options;
    options.view = "Filmic";
    expect_error(ExitCode::kBadRequest,
                 "the view 'Filmic' is unknown; there is: ACES 1.0 - SDR Video, "
                 "Un-tone-mapped, Raw",
                 [&] { Display{options}; });
}

TEST_F(Colour, MissingConfig) {
    const auto file = folder / "none.ocio";
    const Environment ocio("OCIO", file.c_str());
    expect_error(ExitCode::kBadRequest, file.string(), [] { Display{{}}; });
}

TEST_F(Colour, FolderAsConfig) {
    const Environment ocio("OCIO", folder.path().c_str());
    expect_error(ExitCode::kBadRequest, "not a usable OCIO config (named by $OCIO)",
                 [] { Display{{}}; });
}

TEST_F(Colour, BrokenConfig) {
    for (const char* text :
         {"colour: [", "ocio_profile_version: 9\n", "\x89PNG\r\n", "[]"})
        expect_error(ExitCode::kBadRequest, "config.ocio: not a usable OCIO config",
                     [&] { Display{with_config(folder.with("config.ocio", text))}; });
}

TEST_F(Colour, ConfigWhoseTableIsMissing) {
    const auto file =
        folder.with("config.ocio", small_config("Linear Rec.709", "tabled"));
    expect_error(ExitCode::kBadRequest, "film.cube", [&] { Display{with_config(file)}; });
}

TEST_F(Colour, ConfigCutShortAnywhere) {
    const std::string whole = read_text(data_file("ocio/config.ocio"));
    for (std::size_t size = 1; size < whole.size(); size += 61) {
        const auto file = folder.with("config.ocio", whole.substr(0, size));
        survives([&] { Display{with_config(file)}; });
    }
}

}  // namespace
}  // namespace cydonia::render
