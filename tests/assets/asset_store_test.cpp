#include "assets/asset_store.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/log.hpp"
#include "platform/image_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

constexpr std::string_view kTiles =
    R"({"format": 1, "image": "assets/tiles.png", "tileSize": [8, 8], "columns": 2, "count": 4})";

std::string pngOf(int width, int height, std::uint8_t shade = 7) {
    Image image{width, height, {}};
    image.rgba.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, shade);
    return *encodePng(image);
}

class AssetStoreTest : public ::testing::Test {
protected:
    void SetUp() override {
        before_ = setLogSink(
            [this](const LogLine& line) { log_.push_back("[" + line.channel + "] " + line.text); });
        write("player.png", pngOf(128, 32));
        write("platform.png", pngOf(100, 20));
        write("assets/tiles.png", pngOf(16, 16));
        write("assets/cave.tileset.json", kTiles);
    }
    void TearDown() override { setLogSink(before_); }

    void write(const std::string& path, std::string_view bytes) {
        ASSERT_TRUE(writeFile(folder_.path / "project" / path, bytes).ok());
    }

    test::TemporaryFolder folder_;
    AssetStore assets_{folder_.path / "project", folder_.path / "engine"};
    std::vector<std::string> log_;
    LogSink before_;
};

TEST_F(AssetStoreTest, loadingLogsTheNameSizeAndFrameCountOfASheet) {
    assets_.loadTexture("player.png");
    assets_.loadTexture("platform.png");
    assets_.loadTexture("player.png");

    EXPECT_EQ(log_, (std::vector<std::string>{"[Assets] Loaded: player.png (32x32, 4 frames)",
                                              "[Assets] Loaded: platform.png (100x20)"}));
    EXPECT_TRUE(assets_.errors().empty());
}

TEST_F(AssetStoreTest, pixelsAreDecodedOnlyWhenRequested) {
    const TextureId id = assets_.loadTexture("player.png");
    ASSERT_NE(assets_.find(id), nullptr);
    EXPECT_EQ(assets_.find(id)->width, 128);
    EXPECT_TRUE(assets_.find(id)->image.empty());

    EXPECT_EQ(assets_.image(id).rgba.size(), 128u * 32u * 4u);
    EXPECT_FALSE(assets_.find(id)->image.empty());

    assets_.dropImage(id);
    EXPECT_TRUE(assets_.find(id)->image.empty());
}

TEST_F(AssetStoreTest, aMissingImageIsAPlaceholderAndAnErrorUntilItsFileExists) {
    const TextureId id = assets_.loadTexture("assets/later.png");
    EXPECT_EQ(assets_.image(id), placeholderImage());
    EXPECT_TRUE(assets_.isMissing(AssetKind::Texture, id.path));
    ASSERT_EQ(assets_.errors().size(), 1u);
    EXPECT_EQ(assets_.errors()[0].where, "assets/later.png");
    EXPECT_FALSE(assets_.errors()[0].remedy.empty());

    write("assets/later.png", pngOf(4, 4));
    const std::vector<AssetChange> changes = assets_.pollChanges();

    ASSERT_EQ(changes.size(), 1u);
    EXPECT_EQ(changes[0].path, id.path);
    EXPECT_EQ(assets_.image(id).width, 4);
}

TEST_F(AssetStoreTest, aChangedFileIsReloadedOnceAndADamagedOneKeepsTheOldAsset) {
    const TextureId id = assets_.loadTexture("player.png");
    static_cast<void>(assets_.image(id));
    EXPECT_TRUE(assets_.pollChanges().empty());

    write("player.png", pngOf(64, 32, 9));
    EXPECT_EQ(assets_.pollChanges().size(), 1u);
    EXPECT_EQ(assets_.image(id).width, 64);
    EXPECT_EQ(assets_.revisionOf(AssetKind::Texture, id.path), 2u);

    write("player.png", "no picture at all");
    EXPECT_TRUE(assets_.pollChanges().empty());
    EXPECT_TRUE(assets_.pollChanges().empty());
    EXPECT_EQ(assets_.errors().size(), 1u);
    EXPECT_EQ(assets_.image(id).width, 64);

    std::filesystem::remove(folder_.path / "project" / "player.png");
    EXPECT_TRUE(assets_.pollChanges().empty());
    EXPECT_EQ(assets_.image(id).width, 64);
}

TEST_F(AssetStoreTest, aDamagedImageKeepsTheOldOneEvenIfItsPixelsWereDropped) {
    const TextureId id = assets_.loadTexture("player.png");
    static_cast<void>(assets_.image(id));
    assets_.dropImage(id);

    const std::string png = pngOf(64, 64);
    write("player.png", png.substr(0, png.size() - 20));

    EXPECT_TRUE(assets_.pollChanges().empty());
    EXPECT_EQ(assets_.find(id)->width, 128);
    EXPECT_EQ(assets_.revisionOf(AssetKind::Texture, id.path), 1u);
}

TEST_F(AssetStoreTest, pollingChecksAtMostItsBudgetOfFilesAndReachesAllInTurn) {
    assets_.logging = false;
    for (int i = 0; i < 10; ++i)
        assets_.load(AssetKind::Scene, "scenes/" + std::to_string(i) + ".scene.json");
    for (int i = 0; i < 10; ++i) write("scenes/" + std::to_string(i) + ".scene.json", "{}");

    std::size_t changed = 0;
    for (int call = 0; call < 4; ++call) {
        const std::size_t now = assets_.pollChanges(3).size();
        EXPECT_LE(now, 3u);
        changed += now;
    }

    EXPECT_EQ(changed, 10u);
}

TEST_F(AssetStoreTest, aTilesetLoadsAndReloadsItsImage) {
    const TilesetId id = assets_.loadTileset("assets/cave.tileset.json");
    EXPECT_EQ(assets_.tileset(id).tileWidth, 8);
    EXPECT_EQ(assets_.references(AssetKind::Texture, textId("assets/tiles.png")), 1);

    write("assets/cave.tileset.json", R"({"format": 1, "image": "player.png", "tileSize": [16, 16]})");
    EXPECT_EQ(assets_.pollChanges().size(), 1u);

    EXPECT_EQ(assets_.tileset(id).tileWidth, 16);
    EXPECT_EQ(assets_.references(AssetKind::Texture, textId("assets/tiles.png")), 0);
    EXPECT_EQ(assets_.references(AssetKind::Texture, textId("player.png")), 1);
}

TEST_F(AssetStoreTest, assetsWithoutReferencesAreUnloadedAndLoadAgain) {
    const TilesetId tiles = assets_.loadTileset("assets/cave.tileset.json");
    const TextureId player = assets_.loadTexture("player.png");
    const TextureId made = assets_.addTexture("made", placeholderImage());
    assets_.acquire(AssetKind::Tileset, tiles.path);

    EXPECT_EQ(assets_.unloadUnused(), 1u);
    EXPECT_EQ(assets_.find(player), nullptr);
    EXPECT_NE(assets_.find(tiles), nullptr);
    EXPECT_NE(assets_.find(assets_.tileset(tiles).texture), nullptr);
    EXPECT_NE(assets_.find(made), nullptr);

    assets_.release(AssetKind::Tileset, tiles.path);
    EXPECT_EQ(assets_.unloadUnused(), 2u);
    EXPECT_EQ(assets_.size(), 1u);
    EXPECT_EQ(assets_.loadTexture("player.png"), player);
    EXPECT_NE(assets_.find(player), nullptr);
}

TEST_F(AssetStoreTest, engineFilesHaveAPrefixAndFileNamesAreAlsoSearchedInAssets) {
    ASSERT_TRUE(writeFile(folder_.path / "engine" / "fonts" / "a.ttf", "font").ok());

    const FontId font = assets_.loadFont("engine:fonts/a.ttf");
    ASSERT_NE(assets_.find(font), nullptr);
    EXPECT_EQ(assets_.find(font)->bytes, "font");
    EXPECT_EQ(assets_.pathOf(font), "engine:fonts/a.ttf");
    EXPECT_FALSE(assets_.isMissing(AssetKind::Texture, assets_.loadTexture("tiles.png").path));
}

TEST_F(AssetStoreTest, everyPathThatLeavesTheProjectIsRefused) {
    ASSERT_TRUE(writeFile(folder_.path / "secret.png", pngOf(4, 4)).ok());
    ASSERT_TRUE(writeFile(folder_.path / "project" / "sub" / "x.png", pngOf(4, 4)).ok());
    std::filesystem::create_symlink(folder_.path, folder_.path / "project" / "link");
    std::filesystem::create_symlink(folder_.path / "secret.png", folder_.path / "project" / "link.png");
    const std::string secret = (folder_.path / "secret.png").generic_string();
    std::vector<std::string> corpus = {secret, "file://" + secret, "link/secret.png", "link.png",
                                       "sub/../link/secret.png"};
    const std::string ups[] = {"../",
                               "..\\",
                               "./../",
                               "sub/../../",
                               "sub/./../../",
                               "..//",
                               "../../",
                               "%2e%2e/",
                               "%2e%2e%2f",
                               "..%2f",
                               "..%5c",
                               "%c0%ae%c0%ae/",
                               "\xc0\xae\xc0\xae/",
                               "....//",
                               "..;/",
                               ".. /",
                               "../\t",
                               "..\xe2\x81\x84",
                               "\xef\xbc\x8e\xef\xbc\x8e/",
                               "engine:../",
                               "engine:../../",
                               "ENGINE:../"};
    const std::string tails[] = {"secret.png", "project/../secret.png", "secret.png ", "secret.png.",
                                 "secret.png::$DATA"};
    for (const std::string& up : ups) {
        for (const std::string& tail : tails) {
            corpus.push_back(up + tail);
            corpus.push_back(up + std::string{"\0", 1} + tail);
        }
    }
    for (const char* device : {"CON", "PRN", "AUX", "NUL", "COM1", "LPT1", "CON.png", "nul.png"}) {
        for (const char* before :
             {"//./", "\\\\.\\", "\\\\?\\", "C:\\", "C:/", "c:", "/dev/", "//server/share/"}) {
            corpus.push_back(std::string{before} + device);
        }
    }
    ASSERT_GE(corpus.size(), 200u);

    assets_.logging = false;
    for (const std::string& path : corpus) {
        const TextureId id = assets_.loadTexture(path);
        EXPECT_TRUE(assets_.isMissing(AssetKind::Texture, id.path)) << path;
        EXPECT_EQ(assets_.image(id), placeholderImage()) << path;
    }
    EXPECT_EQ(assets_.errors().size(), corpus.size());
    EXPECT_FALSE(assets_.isMissing(AssetKind::Texture, assets_.loadTexture("sub/./x.png").path));
}

TEST_F(AssetStoreTest, damagedFilesOfEveryKindBecomePlaceholdersAndErrors) {
    assets_.logging = false;
    const std::string broken[] = {"", "{", "[]", "null", "\xff", std::string(1000, '['), R"({"format": 99})"};
    int count = 0;
    for (const std::string& bytes : broken) {
        const std::string path = "assets/" + std::to_string(count++);
        write(path, bytes);
        assets_.clearErrors();
        assets_.loadTexture(path);
        EXPECT_EQ(assets_.tileset(assets_.loadTileset(path)).count, 0);
        EXPECT_TRUE(assets_.animation(assets_.loadAnimation(path)).clips.empty());
        EXPECT_EQ(assets_.errors().size(), 3u) << bytes;
    }
    assets_.clearErrors();
    assets_.loadSound("assets/0");
    EXPECT_EQ(assets_.errors().size(), 1u);
}

TEST_F(AssetStoreTest, aTruncatedImageBecomesAPlaceholderWhenDecodedAndRecovers) {
    const std::string png = pngOf(64, 64);
    write("cut.png", png.substr(0, png.size() - 20));
    const TextureId id = assets_.loadTexture("cut.png");
    EXPECT_TRUE(assets_.errors().empty());

    EXPECT_EQ(assets_.image(id), placeholderImage());
    EXPECT_EQ(assets_.image(id), placeholderImage());
    EXPECT_EQ(assets_.errors().size(), 1u);

    write("cut.png", png);
    EXPECT_EQ(assets_.pollChanges().size(), 1u);
    EXPECT_EQ(assets_.image(id).width, 64);
}

TEST_F(AssetStoreTest, aStoreWithoutAProjectHoldsAssetsCreatedByCode) {
    AssetStore store;
    const AnimationId id = store.addAnimation("hero", animationSetOf(playerAnimations));

    EXPECT_EQ(store.animation(id).clips.size(), 3u);
    EXPECT_EQ(store.unloadUnused(), 0u);
    EXPECT_TRUE(store.isMissing(AssetKind::Texture, store.loadTexture("x.png").path));
}

TEST_F(AssetStoreTest, thousandsOfAssetsAreFoundByTheirIds) {
    AssetStore store;
    for (int i = 0; i < 3000; ++i) store.addTexture("t" + std::to_string(i), Image{i + 1, 1, {}});
    for (int i = 0; i < 3000; ++i) {
        const Texture* texture = store.find(TextureId{textId("t" + std::to_string(i))});
        ASSERT_NE(texture, nullptr);
        ASSERT_EQ(texture->width, i + 1);
    }
    EXPECT_EQ(store.find(TextureId{textId("none")}), nullptr);
    EXPECT_EQ(store.find(TextureId{}), nullptr);
}

}  // namespace
}  // namespace plumb
