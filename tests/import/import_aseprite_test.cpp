#include "import/import_aseprite.hpp"

#include <gtest/gtest.h>

#include "assets/animation.hpp"
#include "core/text.hpp"
#include "import/import_file.hpp"
#include "platform/image_file.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

std::string frameText(int x, int y, int milliseconds, int size = 8, int inset = 0) {
    return format(R"("frame": {"x": {}, "y": {}, "w": {}, "h": {}}, "rotated": false, "trimmed": false,
        "spriteSourceSize": {"x": {}, "y": {}, "w": {}, "h": {}}, "sourceSize": {"w": 8, "h": 8}, "duration": {})",
                  x, y, size, size, inset, inset, size, size, milliseconds);
}

constexpr const char* kMeta =
    R"("meta": {"app": "https://www.aseprite.org/", "version": "1.3", "image": "hero.png",
 "format": "RGBA8888", "size": {"w": 16, "h": 16}, "scale": "1", "frameTags": [
  {"name": "walk", "from": 0, "to": 2, "direction": "forward", "color": "#000000ff"},
  {"name": "back", "from": 0, "to": 1, "direction": "reverse"},
  {"name": "sway", "from": 0, "to": 2, "direction": "pingpong"},
  {"name": "die", "from": 3, "to": 3, "direction": "forward", "repeat": "1"}],
 "slices": [{"name": "hit", "color": "#0000ffff", "keys": [{"frame": 0, "bounds": {"x": 1, "y": 1, "w": 4, "h": 4}}]}]})";

std::string arrayForm() {
    std::string text = "{\"frames\": [";
    for (int i = 0; i < 4; ++i) {
        text += format("{}{\"filename\": \"hero {}.ase\", {}}", i == 0 ? "" : ", ", i,
                       frameText(i % 2 * 8, i / 2 * 8, 100 + i * 50));
    }
    return text + "], " + kMeta + "}";
}
std::string hashForm() {
    std::string text = "{\"frames\": {";
    for (int i = 0; i < 4; ++i) {
        text += format("{}\"hero {}.ase\": {{}}", i == 0 ? "" : ", ", i,
                       frameText(i % 2 * 8, i / 2 * 8, 100 + i * 50));
    }
    return text + "}, " + kMeta + "}";
}

class ImportAsepriteTest : public testing::Test {
protected:
    void SetUp() override {
        Image sheet{16, 16, std::vector<std::uint8_t>(16 * 16 * 4, 255)};
        for (std::size_t y = 0; y < 16; ++y) {
            for (std::size_t x = 0; x < 16; ++x)
                sheet.rgba[(y * 16 + x) * 4] = static_cast<std::uint8_t>(y * 16 + x);
        }
        ASSERT_TRUE(writeFile(folder_.path / "hero.png", *encodePng(sheet)).ok());
        ASSERT_TRUE(writeFile(project_ / "project.json", "{}").ok());
    }
    AnimationSet import(const std::string& text) {
        EXPECT_TRUE(writeFile(folder_.path / "hero.json", text).ok());
        const Result<ImportReport> imported = importFile(folder_.path / "hero.json", {}, project_);
        EXPECT_TRUE(imported.ok()) << imported.error().text();
        if (!imported) return {};
        report_ = *imported;
        std::vector<Error> problems;
        Result<AnimationSet> set = parseAnimationSet(*readFile(project_ / report_.scene), "test", problems);
        EXPECT_TRUE(problems.empty());
        return set ? *set : AnimationSet{};
    }

    test::TemporaryFolder folder_;
    Path project_ = folder_.path / "game";
    ImportReport report_;
};

TEST_F(ImportAsepriteTest, tagsBecomeClipsForFramesAsHashAndAsArray) {
    for (const std::string& text : {arrayForm(), hashForm()}) {
        const AnimationSet set = import(text);
        EXPECT_EQ(report_.scene, "assets/hero.anim.json");
        EXPECT_EQ(set.frameWidth, 8);
        ASSERT_EQ(set.clips.size(), 4u);
        EXPECT_EQ(set.clips[0].name, "walk");
        ASSERT_EQ(set.clips[0].frames.size(), 3u);
        EXPECT_EQ(set.clips[0].frames[1].cellX, 1);
        EXPECT_EQ(set.clips[0].frames[2].cellY, 1);
        EXPECT_FLOAT_EQ(set.clips[0].frames[2].seconds, 0.2f);
        EXPECT_EQ(set.clips[1].frames[0].cellX, 1) << "backwards";
        EXPECT_EQ(set.clips[2].loop, LoopMode::PingPong);
        EXPECT_EQ(set.clips[3].loop, LoopMode::Once);
        EXPECT_TRUE(report_.problems.empty()) << report_.text();
    }
}

TEST_F(ImportAsepriteTest, slicesAndColorsAreKeptAsData) {
    import(arrayForm());
    const Json json = *parseJson(*readFile(project_ / "assets/hero.anim.json"), "test");
    EXPECT_EQ(json["aseprite"]["slices"][0]["name"], "hit");
    EXPECT_EQ(json["clips"][0]["aseprite"]["color"], "#000000ff");
    EXPECT_NE(report_.text().find("1 slices are kept"), std::string::npos);
}

TEST_F(ImportAsepriteTest, trimmedFramesAreCopiedToCellsOfEqualSize) {
    std::string text = "{\"frames\": [{" + frameText(0, 0, 100) + "}, {" + frameText(10, 9, 100, 4, 2) +
                       "}], " + R"("meta": {"image": "hero.png"}})";
    const AnimationSet set = import(text);

    ASSERT_EQ(set.clips.size(), 1u) << "without tags all frames are one clip";
    ASSERT_EQ(set.clips[0].frames.size(), 2u);
    const Result<Image> image = decodeImage(*readFile(project_ / set.image), "test");
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->width, 16);
    const auto red = [&](std::size_t x, std::size_t y) { return image->rgba[(y * 16 + x) * 4]; };
    EXPECT_EQ(red(8 + 2, 2), 9 * 16 + 10) << "the first pixel of the second frame";
    EXPECT_EQ(red(8 + 1, 1), 0);
}

TEST_F(ImportAsepriteTest, framesOutsideTheImageAreReported) {
    import("{\"frames\": [{" + frameText(0, 0, 100) + "}, {" + frameText(12, 0, 100) + "}], " +
           R"("meta": {"image": "hero.png"}})");
    EXPECT_NE(report_.text().find("1 frames reach beyond the image's 16 x 16 px"), std::string::npos)
        << report_.text();
}

TEST_F(ImportAsepriteTest, aMissingImageOrAnotherKindOfFileIsRejected) {
    ASSERT_TRUE(writeFile(folder_.path / "hero.json", "{\"a\": 1}").ok());
    const Result<ImportReport> other = importFile(folder_.path / "hero.json", {}, project_);
    ASSERT_FALSE(other.ok());
    EXPECT_NE(other.error().remedy.find("Aseprite"), std::string::npos);
    std::filesystem::remove(folder_.path / "hero.png");
    ASSERT_TRUE(writeFile(folder_.path / "hero.json", arrayForm()).ok());
    EXPECT_FALSE(importFile(folder_.path / "hero.json", {}, project_).ok());
}

}  // namespace
}  // namespace plumb
