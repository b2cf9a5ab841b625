#include <gtest/gtest.h>

#include "core/file.hpp"
#include "core/random.hpp"
#include "platform/paths.hpp"
#include "render/recording_device.hpp"
#include "render/renderer.hpp"
#include "render/text_painter.hpp"

namespace plumb {
namespace {

Font loadFont(const std::string& name) {
    Result<std::string> bytes = readFile(engineAssets() / "fonts" / name);
    EXPECT_TRUE(bytes);
    Result<Font> font = Font::fromBytes(*bytes, name);
    EXPECT_TRUE(font);
    return std::move(*font);
}

std::u32string decoded(std::string_view text) {
    std::u32string letters;
    while (!text.empty()) letters.push_back(takeCodepoint(text));
    return letters;
}

class TextTest : public testing::Test {
protected:
    Font font = loadFont("press_start_2p.ttf");  // at size 8 px every letter is 8 px wide
    TextLayout layout;

    void layOut(std::string_view text, const TextShape& shape) { layOutText(font, text, shape, layout); }
    [[nodiscard]] std::vector<Vec2> pens() const {
        std::vector<Vec2> places;
        for (const PlacedGlyph& placed : layout.glyphs) places.push_back(placed.pen);
        return places;
    }
};

TEST_F(TextTest, glyphsAreSideBySideOnTheBaseLine) {
    layOut("abc", {});
    const float base = font.ascent() * 8.0f;
    EXPECT_EQ(pens(), (std::vector<Vec2>{{0.0f, base}, {8.0f, base}, {16.0f, base}}));
    EXPECT_EQ(layout.size.x, 24.0f);
    EXPECT_EQ(layout.lines, 1);
}

TEST_F(TextTest, linesBreakBetweenWordsAndTheSpaceMayExtendBeyond) {
    layOut("one two three", {.wrapWidth = 60.0f});
    EXPECT_EQ(layout.lines, 2);
    EXPECT_EQ(layout.size.x, 56.0f);
    EXPECT_EQ(layout.glyphs[6].pen.x, 0.0f);  // the t of "three"
    EXPECT_GT(layout.glyphs[6].pen.y, layout.glyphs[5].pen.y);
}

TEST_F(TextTest, aWordLongerThanALineIsSplit) {
    layOut("abcdefghij", {.wrapWidth = 32.0f});
    EXPECT_EQ(layout.lines, 3);
    EXPECT_EQ(layout.glyphs[4].pen.x, 0.0f);
    layOut("a", {.wrapWidth = 1.0f});
    EXPECT_EQ(layout.lines, 1);
}

TEST_F(TextTest, noLineIsWiderThanTheWrapWidthUnlessAGlyphIs) {
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(seed);
        Random random{seed};
        std::string text;
        std::size_t letters = 0;
        for (std::uint32_t i = 0; i < 60; ++i) {
            const bool letter = random.below(5) != 0;
            text += letter ? 'x' : random.below(6) == 0 ? '\n' : ' ';
            letters += letter ? 1u : 0u;
        }
        const float width = 8.0f + static_cast<float>(random.below(100));
        layOut(text, {.wrapWidth = width});
        EXPECT_EQ(layout.glyphs.size(), letters);
        for (const PlacedGlyph& placed : layout.glyphs) {
            EXPECT_GE(placed.pen.x, 0.0f);
            EXPECT_LE(placed.pen.x + 8.0f, width);
        }
    }
}

TEST_F(TextTest, aligningMovesEachLineByItsOwnWidth) {
    layOut("abcd\nab", {.align = TextAlign::Center});
    EXPECT_EQ(layout.glyphs[0].pen.x, -16.0f);
    EXPECT_EQ(layout.glyphs[4].pen.x, -8.0f);
    layOut("abcd\nab", {.align = TextAlign::Right});
    EXPECT_EQ(layout.glyphs[0].pen.x, -32.0f);
    EXPECT_EQ(layout.glyphs[4].pen.x, -16.0f);
}

TEST_F(TextTest, emptyLinesHaveTheLineHeight) {
    layOut("a\n\nb", {});
    EXPECT_EQ(layout.lines, 3);
    EXPECT_EQ(layout.glyphs[1].pen.x, 0.0f);
    layOut("", {});
    EXPECT_EQ(layout.lines, 0);
    EXPECT_EQ(layout.size, (Vec2{}));
}

TEST(Utf8, readsCharactersAndReplacesInvalidBytes) {
    EXPECT_EQ(decoded("a\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80z"), U"a\u00e4\u20ac\U0001f600z");
    EXPECT_EQ(decoded("\xff\x61"), U"\ufffd\u0061");
    EXPECT_EQ(decoded("\xe2\x82"), U"\ufffd\ufffd");
    EXPECT_EQ(decoded("\xc0\x80"), U"\ufffd\ufffd");
}

TEST(Font, detectsPixelFontsByTheirOutlines) {
    EXPECT_TRUE(loadFont("press_start_2p.ttf").isPixelFont());
    EXPECT_TRUE(loadFont("silkscreen.ttf").isPixelFont());
    EXPECT_TRUE(loadFont("tiny5.ttf").isPixelFont());
    EXPECT_FALSE(loadFont("b612.otf").isPixelFont());
    EXPECT_FALSE(loadFont("b612_mono.otf").isPixelFont());
}

TEST(Font, glyphsOfPixelFontsHaveNoPartialCoverage) {
    const Font font = loadFont("press_start_2p.ttf");
    const Font::Glyph glyph = font.draw(font.glyphOf(U'A'), 8);
    ASSERT_GE(glyph.image.width, 7);
    ASSERT_GE(glyph.image.height, 7);
    for (std::size_t i = 3; i < glyph.image.rgba.size(); i += 4) {
        EXPECT_TRUE(glyph.image.rgba[i] == 0 || glyph.image.rgba[i] == 255);
    }
}

TEST(Font, filesThatAreNotFontsAreRejected) {
    EXPECT_FALSE(Font::fromBytes("", "a.ttf"));
    EXPECT_FALSE(Font::fromBytes("not a font at all", "a.ttf"));
    Result<std::string> bytes = readFile(engineAssets() / "fonts" / "silkscreen.ttf");
    ASSERT_TRUE(bytes);
    EXPECT_FALSE(Font::fromBytes(bytes->substr(0, 5000), "a.ttf"));
}

TEST(TextPainter, rasterizesAGlyphOnceAndSharesOneTexture) {
    RecordingDevice device;
    Renderer renderer{device};
    TextPainter painter{device};
    const Font font = loadFont("silkscreen.ttf");
    DrawList list;
    for (int frame = 0; frame < 3; ++frame) {
        device.clearDraws();
        list.begin({.center = {160.0f, 90.0f}, .size = {320.0f, 180.0f}});
        painter.draw(list, font, "SCORE 000123", {10.0f, 10.0f}, {});
        painter.draw(list, font, "SCORE", {10.0f, 40.0f}, {.shadow = {0, 0, 0, 255}});
        renderer.draw(list, {.width = 320, .height = 180});
        EXPECT_EQ(device.texturesCreated, 1u);
        EXPECT_EQ(device.drawCalls(), 1u);
        EXPECT_EQ(list.spriteCount(), 11u + 10u);
    }
}

TEST(TextPainter, glyphsOfPixelFontsAreAlignedToPixelsAtTheirOwnSize) {
    RecordingDevice device;
    TextPainter painter{device};
    const Font font = loadFont("press_start_2p.ttf");
    DrawList list;
    list.begin({.center = {160.0f, 90.0f}, .size = {320.0f, 180.0f}, .zoom = 1.0f});
    painter.draw(list, font, "Hello!", {10.3f, 20.8f}, {});
    for (const SpriteInstance& letter : list.instances()) {
        const Vec2 corner = letter.center - letter.half;
        EXPECT_EQ(corner.x, std::floor(corner.x));
        EXPECT_EQ(corner.y, std::floor(corner.y));
        EXPECT_EQ(letter.half.x * 2.0f * kUvPerTexel, static_cast<float>(letter.uv[2] - letter.uv[0]));
    }
}

}  // namespace
}  // namespace plumb
