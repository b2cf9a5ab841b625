// What the program of an exported game shows on Windows: icon, name and version.

#include "editor/model/headless/windows_resources.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "core/text.hpp"
#include "editor/model/headless/icon_file.hpp"
#include "platform/image_file.hpp"

namespace plumb::editor {
namespace {

std::uint32_t numberAt(const std::string& bytes, std::size_t at, int size) {
    std::uint32_t number = 0;
    for (int i = 0; i < size; ++i)
        number |=
            static_cast<std::uint32_t>(static_cast<unsigned char>(bytes.at(at + static_cast<std::size_t>(i))))
            << (8 * i);
    return number;
}

Image randomImage(Random& random, int side) {
    Image image{side, side, {}};
    for (int i = 0; i < side * side * 4; ++i)
        image.rgba.push_back(static_cast<std::uint8_t>(1 + random.below(255)));  // none without a color
    return image;
}

/// The sum of a color over all pixels, weighted by opacity; channel 3: of the opacity; per pixel.
double meanOf(const Image& image, std::size_t channel) {
    double sum = 0.0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        sum += channel == 3 ? image.rgba[i + 3] : image.rgba[i + channel] * image.rgba[i + 3] / 255.0;
    return sum / (static_cast<double>(image.width) * image.height);
}

TEST(Shrunk, keepsTheMeanOfEachColorAndOneColorStaysItself) {
    Random random = Random::seeded(7);
    for (const int side : {16, 17, 40, 100}) {
        const Image image = randomImage(random, side);
        EXPECT_EQ(shrunk(image, side), image) << "the same size";
        for (int small = 1; small < side; small += 5) {
            const Image made = shrunk(image, small);
            ASSERT_EQ(made.rgba.size(), static_cast<std::size_t>(small * small * 4));
            for (std::size_t channel = 0; channel < 4; ++channel)
                EXPECT_NEAR(meanOf(made, channel), meanOf(image, channel), 1.0) << side << " to " << small;
            const Image plain{side, side, std::vector<std::uint8_t>(image.rgba.size(), 93)};
            for (const std::uint8_t part : shrunk(plain, small).rgba) ASSERT_EQ(part, 93);
        }
    }
}

TEST(IconFile, hasEverySizeUpToThatOfThePictureAndTheyAreWhereItSays) {
    Random random = Random::seeded(3);
    for (const auto& [side, count] :
         {std::pair{16, 1u}, {31, 2u}, {48, 4u}, {200, 5u}, {256, 6u}, {300, 6u}}) {
        const Result<std::string> icon = iconFile(randomImage(random, side), "icon.png");
        ASSERT_TRUE(icon.ok()) << icon.error().text();
        ASSERT_EQ(numberAt(*icon, 2, 2), 1u) << "an icon";
        ASSERT_EQ(numberAt(*icon, 4, 2), count) << side;
        std::size_t end = 6 + 16 * count;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t entry = 6 + 16 * i;
            const std::uint32_t size = numberAt(*icon, entry + 8, 4);
            ASSERT_EQ(numberAt(*icon, entry + 12, 4), end);
            const Result<Image> picture = decodeImage(std::string_view{*icon}.substr(end, size), "entry");
            ASSERT_TRUE(picture.ok()) << picture.error().text();
            EXPECT_EQ(picture->width & 255, static_cast<int>(numberAt(*icon, entry, 1)));
            EXPECT_LE(picture->width, side);
            end += size;
        }
        EXPECT_EQ(end, icon->size());
    }
}

TEST(IconFile, refusesAPictureThatIsNotSquareOrTooSmall) {
    for (const auto& [width, height] : {std::pair{32, 16}, {15, 15}, {16, 32}}) {
        const Image picture{width, height,
                            std::vector<std::uint8_t>(static_cast<std::size_t>(width * height * 4))};
        const Result<std::string> icon = iconFile(picture, "assets/icon.png");
        ASSERT_FALSE(icon.ok());
        EXPECT_EQ(icon.error().where, "assets/icon.png");
        EXPECT_NE(icon.error().what.find(format("found {}x{} px", width, height)), std::string::npos);
    }
}

TEST(ResourceScript, hasTheVersionAsFourNumbersAndTextsInQuotes) {
    const std::pair<const char*, const char*> versions[] = {{"1.2.3", "1,2,3,0"},
                                                            {"", "0,0,0,0"},
                                                            {"v2", "2,0,0,0"},
                                                            {"1.2-rc3.4.5", "1,2,3,4"},
                                                            {"99999999999.1", "65535,1,0,0"}};
    Project project;
    project.name = "The \"best\" C:\\\n1 ICON \"x\"";
    for (const auto& [version, numbers] : versions) {
        project.version = version;
        const std::string script = resourceScript(project);
        EXPECT_NE(script.find(format("FILEVERSION {}\n", numbers)), std::string::npos) << script;
        EXPECT_NE(script.find("\"ProductName\", \"The \"\"best\"\" C:\\\\1 ICON \"\"x\"\"\"\n"),
                  std::string::npos)
            << script;
        EXPECT_EQ(script.find("\n1 ICON"), std::string::npos) << "it has no icon";
    }
    project.icon = "assets/icon.png";
    EXPECT_NE(resourceScript(project).find("\n1 ICON \"game.ico\"\n"), std::string::npos);
}

}  // namespace
}  // namespace plumb::editor
