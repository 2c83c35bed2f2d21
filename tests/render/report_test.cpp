// The page's text: what a reader's browser makes of it is tests/e2e/report_test.cpp's.
#include "render/report/report.h"

#include <gtest/gtest.h>

#include <regex>

#include "field/base64.h"
#include "field/error.h"
#include "field/image.h"
#include "render/report/template.h"

namespace cydonia::render {
namespace {

using testing::Test;

bool has(const std::string& page, std::string_view text) {
    return page.find(text) != std::string::npos;
}

ReportPicture picture(const std::string& label) {
    return {label, "frames/" + label + ".png", "not really a JPEG", 640, 360};
}

// Everything that a page may have.
Report full() {
    Report report;
    report.title = "A bar of shadow";
    report.facts = {{"Seed", "7"}};
    report.frames = {picture("overhead"), picture("oblique")};
    report.videos = {{"day", "frames/day.mp4", "", picture("still")}};
    report.images = {{"bar",
                      {radians(215.0), radians(25.0)},
                      "reads well",
                      true,
                      Field<std::uint8_t>(4, 3, 1),
                      {},
                      {picture("cast")}}};
    report.relief = {picture("relief")};
    report.stages = {{"1 distance", 2.0, "neighbours = 16\n"}};
    report.other_steps = {{"check", 1.0, ""}};
    report.figures = {{"terrain", {{"spacing", "10"}}}};
    report.scene = "seed = 7\n";
    report.version = "0.1.0";
    report.heights = Field<float>(4, 3, 1.0f);
    report.heights(1, 1) = 3.0f;
    report.three = "var THREE = {};";
    return report;
}

std::string with_title(const std::string& title) {
    Report report = full();
    report.title = report.scene = title;
    report.stages[0].options = report.figures[0].rows[0].value = title;
    report.images[0].name = report.images[0].verdict = report.frames[0].label = title;
    return report_page(report);
}

}  // namespace

TEST(Template, FillsListsAndTextsAndWhatIsNotThere) {
    const Values values = {{{"title", "a<b"}, {"none", ""}},
                           {{"rows", {{{{"x", "1"}}}, {{{"x", "2"}}}}}, {"empty", {}}}};
    EXPECT_EQ(filled("{{title}} {{{title}}}", values), "a&lt;b a<b");
    EXPECT_EQ(filled("{{#rows}}[{{x}}{{title}}]{{/rows}}", values), "[1a&lt;b][2a&lt;b]");
    EXPECT_EQ(filled("{{#title}}yes{{/title}}{{^title}}no{{/title}}", values), "yes");
    EXPECT_EQ(filled("{{#none}}yes{{/none}}{{^none}}no{{/none}}", values), "no");
    EXPECT_EQ(filled("{{#empty}}yes{{/empty}}{{^empty}}no{{/empty}}", values), "no");
    EXPECT_EQ(filled("{{^rows}}no{{/rows}}{{unknown}}", values), "");
}

TEST(Template, ValuesAreNoTemplates) {
    EXPECT_EQ(filled("{{{a}}}{{b}}", {{{"a", "{{b}}"}, {"b", "{{{a}}}"}}}),
              "{{b}}{{{a}}}");
}

TEST(Template, PartsThatDoNotCloseAreRefused) {
    for (const char* broken : {"{{title", "{{{title}}", "{{#rows}}x", "{{^rows}}x"})
        EXPECT_THROW(filled(broken, {}), Error) << broken;
}

TEST(Base64, VectorsOfRfc4648) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

TEST(ReportPage, HasEveryPart) {
    const std::string page = report_page(full());
    for (const char* part : {"A bar of shadow",
                             "id=\"land\"",
                             "id=\"dial\"",
                             "data-heights=\"",
                             "overhead",
                             "oblique",
                             "<video",
                             "frames/day.mp4",
                             "poster=\"data:",
                             "reads well",
                             "The land</h2>",
                             "1 distance",
                             "neighbours = 16",
                             "All figures",
                             "spacing",
                             "seed = 7",
                             "var THREE",
                             "class Land",
                             "id=\"theme\"",
                             "prefers-color-scheme: dark",
                             "width=device-width",
                             "data-azimuth=\"215\""})
        EXPECT_TRUE(has(page, part)) << part;
    EXPECT_FALSE(has(page, "{{"));
}

TEST(ReportPage, WhatIsMissingIsLeftOut) {
    Report report;
    report.title = "Nothing yet";
    const std::string page = report_page(report);
    EXPECT_TRUE(has(page, "<h1>Nothing yet</h1>"));
    for (const char* part : {"<img", "<video", "<canvas", "class Land", "THREE",
                             "All figures", "The land</h2>", "The shadow of"})
        EXPECT_FALSE(has(page, part)) << part;
}

TEST(ReportPage, WithoutThreeTheLandIsStillThere) {
    Report report = full();
    report.three.clear();
    const std::string page = report_page(report);
    EXPECT_FALSE(has(page, "three.js authors"));
    EXPECT_TRUE(has(page, "<canvas"));
    EXPECT_TRUE(has(page, "libjs-three"));  // what the script says when it is missing
}

TEST(ReportPage, AStrangersTextStaysText) {
    const std::string plain = with_title("plain");  // what is ours has such tags, too
    const auto count = [](const std::string& page, const std::string& tag) {
        std::size_t n = 0;
        for (auto at = page.find(tag); at != page.npos; at = page.find(tag, at + 1)) ++n;
        return n;
    };
    for (const char* title :
         {"</script><script>alert(1)</script>", "\"><img src=x onerror=alert(1)>",
          "' onload='alert(1)", "</title><h1>", "<!--", "</style>", "]]>",
          "</pre></details>"}) {
        const std::string page = with_title(title);
        for (const char* tag : {"<script", "</script", "<img", "<h1", "<!--", "</style",
                                "</pre", "<svg", "onerror=\"", "onload=\""})
            EXPECT_EQ(count(page, tag), count(plain, tag)) << tag << " in " << title;
    }
    EXPECT_TRUE(has(with_title("{{{style}}}"), "<h1>{{{style}}}</h1>"));
}

TEST(ReportPage, AScriptCannotEndItsOwnElement) {
    Report report = full();
    report.three = "var a = \"</script><b>\", b = \"<!-- <script>\";";
    const std::string page = report_page(report);
    EXPECT_TRUE(has(page, "\"<\\/script><b>\""));
    EXPECT_TRUE(has(page, "\"<\\!-- <script>\""));
}

TEST(ReportPage, LinksStayInTheFolder) {
    Report report = full();
    report.frames[0].file = "frames/a b\"<javascript:x.png";
    const std::string page = report_page(report);
    EXPECT_TRUE(has(page, "href=\"frames/a%20b%22%3Cjavascript%3Ax.png\""));
}

TEST(ReportPage, NamesNothingOfTheNetwork) {
    Report report = full();
    const std::string page = report_page(report);
    static const std::regex kAddress(
        R"((src|href|poster|action|data)=["']?(https?:)?//|url\(|@import|fetch\(|XMLHttpRequest|<link|<iframe)");
    std::smatch found;
    EXPECT_FALSE(std::regex_search(page, found, kAddress)) << found.str();
    EXPECT_TRUE(has(page, "default-src 'none'"));
}

TEST(ReportPage, HeightsAreSixteenBitsOfTheRelief) {
    const std::string page = report_page(full());
    std::string levels(24, '\0');
    levels[10] = levels[11] = '\xff';  // sample 5 of 12, the highest
    EXPECT_TRUE(has(page, "data-heights=\"" + base64(levels) + "\""));
    EXPECT_TRUE(has(page, "data-low=\"1\" data-high=\"3\""));
    EXPECT_TRUE(has(page, "data-target=\"" + base64("\xff\x0f") + "\""));

    Report flat = full();
    flat.heights = Field<float>(2, 2, 5.0f);
    EXPECT_TRUE(has(report_page(flat), base64(std::string(8, '\0'))));
}

}  // namespace cydonia::render
