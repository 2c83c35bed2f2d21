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

TEST_F(Colour, EveryDisplayHasEveryView) {
    for (const char* display : {"sRGB", "Rec.1886 Rec.709", "P3-D65"})
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
        "the display 'IMAX' is unknown; there is: sRGB, Rec.1886 Rec.709, P3-D65",
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
