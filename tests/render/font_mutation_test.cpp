// Damaged fonts are rejected or drawn without a crash. PLUMB_FONT_MUTATIONS sets the number of fonts to test.

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "render/font.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/places.hpp"

namespace plumb {
namespace {

constexpr const char* kWickwood = "projects/platformer/assets/wickwood.ttf";

std::uint64_t mutationCount() {
    const char* wanted = std::getenv("PLUMB_FONT_MUTATIONS");
    return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 400;
}

std::string bytesOf(const char* path) { return *readFile(test::sourceFolder() / path); }

std::vector<std::string> allFonts() {
    std::vector<std::string> fonts;
    for (const char* folder : {"assets", "projects"}) {
        for (const char* ending : {".ttf", ".otf"}) {
            for (const std::string& name : filesBelow(test::sourceFolder() / folder, ending))
                fonts.push_back(*readFile(test::sourceFolder() / folder / name));
        }
    }
    return fonts;
}

void expectDrawnOrRefused(std::string bytes) {
    const Result<Font> font = Font::fromBytes(std::move(bytes), "damaged.ttf");
    if (!font) {
        EXPECT_EQ(font.error().where, "damaged.ttf");
        EXPECT_FALSE(font.error().what.empty());
        EXPECT_FALSE(font.error().remedy.empty());
        return;
    }
    EXPECT_TRUE(std::isfinite(font->lineHeight()) && font->lineHeight() >= 1.0f);
    int last = 0;
    for (char32_t letter = U' '; letter <= U'~'; ++letter) {
        const int glyph = font->glyphOf(letter);
        EXPECT_TRUE(std::isfinite(font->advance(glyph) + font->kerning(last, glyph)));
        const Font::Glyph drawn = font->draw(glyph, 14);
        const auto pixels =
            static_cast<std::size_t>(drawn.image.width) * static_cast<std::size_t>(drawn.image.height);
        EXPECT_EQ(drawn.image.rgba.size(), pixels * 4);
        last = glyph;
    }
    for (const char32_t letter : {U'\u00e9', U'\u20ac', U'\U0001f600', U'\U0010ffff'})
        static_cast<void>(font->draw(font->glyphOf(letter), 48));
}

/// Returns the offset of a table in a font file.
std::size_t placeOf(const std::string& font, std::string_view table) {
    const std::size_t record = font.find(table);
    const auto byte = [&](std::size_t i) {
        return std::size_t{static_cast<unsigned char>(font[record + 8 + i])};
    };
    return byte(0) << 24 | byte(1) << 16 | byte(2) << 8 | byte(3);
}

TEST(FontMutations, propertyADamagedFontIsRejectedOrDrawn) {
    const std::vector<std::string> fonts = allFonts();
    ASSERT_GE(fonts.size(), 7u);
    for (std::uint64_t seed = 1; seed <= mutationCount(); ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        std::string bytes = fonts[seed % fonts.size()];
        // Half of the damage is at the start, which contains the table directory and the small tables that
        // refer to the others.
        constexpr std::size_t kStart = 1024;
        if (random.below(2) == 0) {
            bytes = test::withWrongBytes(bytes.substr(0, kStart), random, 8) + bytes.substr(kStart);
        } else {
            bytes = test::withWrongBytes(std::move(bytes), random, 200);
        }
        expectDrawnOrRefused(std::move(bytes));
        ASSERT_FALSE(HasFailure());
    }
}

TEST(FontMutations, everyByteOfTheTableDirectoryMayBeWrong) {
    const std::string font = bytesOf(kWickwood);
    constexpr std::size_t kContents = 12 + 16 * 14;
    for (std::size_t at = 0; at < kContents; ++at) {
        for (const char byte : {'\0', '\x7f', '\xff'}) {
            SCOPED_TRACE(format("byte {} is {}", at, static_cast<int>(byte)));
            std::string damaged = font;
            damaged[at] = byte;
            expectDrawnOrRefused(std::move(damaged));
        }
    }
}

TEST(FontMutations, aGlyphThatContainsItselfIsRejected) {
    std::string font = bytesOf(kWickwood);
    const int glyph = Font::fromBytes(font, "whole.ttf")->glyphOf(U'A');
    // Make the glyph of A the first glyph of "glyf", and make that glyph a composite of A.
    const std::size_t glyf = placeOf(font, "glyf");
    const std::size_t loca = placeOf(font, "loca");
    const bool isLong = font[placeOf(font, "head") + 51] != 0;
    const std::size_t width = isLong ? 4 : 2;
    const std::size_t entry = loca + static_cast<std::size_t>(glyph) * width;
    font.replace(entry, width * 2,
                 std::string(width, '\0') + std::string(width - 1, '\0') + (isLong ? ' ' : '\x10'));
    const std::string composite{'\xff', '\xff', 0, 0, 0, 0, 0, 100, 0, 100, 0, 2, 0, static_cast<char>(glyph),
                                0,      0};
    font.replace(glyf, composite.size(), composite);
    const Result<Font> read = Font::fromBytes(font, "circle.ttf");
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().what.find("damaged"), std::string::npos) << read.error().text();
}

TEST(FontMutations, aHugeGlyphIsNotDrawn) {
    std::string font = bytesOf(kWickwood);
    const Result<Font> whole = Font::fromBytes(font, "whole.ttf");
    const Font::Glyph letter = whole->draw(whole->glyphOf(U'A'), 160);
    EXPECT_FALSE(letter.image.empty());
    const std::size_t head = placeOf(font, "head");
    font[head + 18] = 0, font[head + 19] = 16;  // 16 units per em make every letter 64 times as large
    const Result<Font> huge = Font::fromBytes(font, "huge.ttf");
    ASSERT_TRUE(huge);
    EXPECT_TRUE(huge->draw(huge->glyphOf(U'A'), 160).image.empty());
}

}  // namespace
}  // namespace plumb
