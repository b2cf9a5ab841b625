#include "render/texture_library.hpp"

#include <gtest/gtest.h>

#include "render/recording_device.hpp"
#include "render/tileset_looks.hpp"

namespace plumb {
namespace {

Image filled(int width, int height, std::uint8_t value) {
    return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width * height * 4), value)};
}

class TextureLibraryTest : public testing::Test {
protected:
    TextureLibraryTest() { assets.logging = false; }

    [[nodiscard]] std::uint8_t firstByteOf(const TextureRegion& region) const {
        const Image& page = device.image(region.texture);
        return page.rgba[static_cast<std::size_t>((region.y * page.width + region.x) * 4)];
    }

    RecordingDevice device;
    AssetStore assets;
    TextureLibrary textures{device, assets};
};

TEST_F(TextureLibraryTest, aTextureIsUploadedOnce) {
    const TextureId id = assets.addTexture("a", filled(16, 8, 7));
    const TextureRegion first = textures.regionOf(id);
    EXPECT_EQ(first.width, 16);
    EXPECT_EQ(firstByteOf(first), 7);
    EXPECT_EQ(textures.regionOf(id), first);
    EXPECT_EQ(device.texturesCreated, 1u);
}

TEST_F(TextureLibraryTest, anEmptyIdIsTheWhitePixelAndAMissingTextureThePlaceholder) {
    EXPECT_EQ(textures.regionOf({}).texture, TextureHandle{});
    EXPECT_NE(textures.regionOf(assets.loadTexture("nowhere.png")).texture, TextureHandle{});
}

TEST_F(TextureLibraryTest, aChangedTextureIsUploadedAgain) {
    const TextureId id = assets.addTexture("a", filled(16, 16, 1));
    const TextureRegion before = textures.regionOf(id);
    const std::uint32_t version = textures.version();

    assets.addTexture("a", filled(16, 16, 2));
    textures.refresh();
    EXPECT_EQ(textures.regionOf(id), before);
    EXPECT_EQ(firstByteOf(before), 2);
    EXPECT_EQ(textures.version(), version);

    assets.addTexture("a", filled(32, 32, 3));
    textures.refresh();
    EXPECT_EQ(textures.regionOf(id).width, 32);
    EXPECT_NE(textures.version(), version) << "users of the old region must rebuild";
}

TEST_F(TextureLibraryTest, theRegionOfAnUnloadedTextureIsReused) {
    const TextureId gone = assets.loadTexture("nowhere.png");
    const TextureRegion place = textures.regionOf(gone);
    const std::uint32_t version = textures.version();
    EXPECT_EQ(assets.unloadUnused(), 1u);

    textures.refresh();

    EXPECT_NE(textures.version(), version) << "users of the old region must rebuild";
    const TextureId next = assets.addTexture("next", filled(place.width, place.height, 9));
    EXPECT_EQ(textures.regionOf(next), place);
    EXPECT_EQ(device.texturesCreated, 1u);
}

TEST_F(TextureLibraryTest, aSourceOutsideTheImageIsClipped) {
    const TextureRegion region{TextureHandle{1}, 100, 200, 32, 16};
    EXPECT_EQ(region.part({8.0f, 0.0f, 8.0f, 16.0f}), (Rect{108.0f, 200.0f, 8.0f, 16.0f}));
    EXPECT_EQ(region.part({24.0f, -4.0f, 16.0f, 16.0f}), (Rect{124.0f, 200.0f, 8.0f, 12.0f}));
    EXPECT_TRUE(region.part({32.0f, 0.0f, 16.0f, 16.0f}).empty());
}

class TilesetLooksTest : public TextureLibraryTest {
protected:
    TilesetLooksTest() {
        Tileset set;
        set.texture = assets.addTexture("tiles", filled(64, 32, 9));
        set.tileWidth = set.tileHeight = 16;
        set.columns = 4;
        set.count = 8;
        Tile flame;
        flame.id = 2;
        flame.animation = {{2, 0.5f}, {5, 0.5f}};
        set.tiles = {flame};
        id = assets.addTileset("set", set);
    }
    TileSheet sheetAt(double seconds, Vec2 size = {}) {
        return looks.sheet(assets, textures, id, size, seconds);
    }

    TilesetLooks looks;
    TilesetId id;
};

TEST_F(TilesetLooksTest, tilesAreArrangedInRowsOfTheImage) {
    const TileSheet sheet = sheetAt(0.0);
    ASSERT_EQ(sheet.looks.size(), 8u);
    const TextureRegion region = textures.regionOf(assets.find(id)->texture);
    EXPECT_EQ(sheet.looks[5].source, region.part({16.0f, 16.0f, 16.0f, 16.0f}));
    EXPECT_EQ(sheet.cellSize, (Vec2{16.0f, 16.0f}));
    EXPECT_EQ(sheetAt(0.0, {32.0f, 32.0f}).scale, (Vec2{2.0f, 2.0f}));
}

TEST_F(TilesetLooksTest, animatedTilesShowTheFrameOfTheMoment) {
    const TileLook first = sheetAt(0.1).looks[2];
    EXPECT_TRUE(first.animated);
    const TileSheet later = sheetAt(0.6);
    EXPECT_EQ(later.looks[2].source, later.looks[5].source);
    EXPECT_FALSE(later.looks[5].animated);
    EXPECT_NE(first.source, later.looks[2].source);
}

TEST_F(TilesetLooksTest, theVersionChangesOnlyIfMoreThanTheTimeChanged) {
    const std::uint32_t version = sheetAt(0.0).version;
    EXPECT_EQ(sheetAt(3.0).version, version);
    assets.addTexture("tiles", filled(128, 32, 1));
    textures.refresh();
    EXPECT_NE(sheetAt(3.0).version, version);
}

}  // namespace
}  // namespace plumb
