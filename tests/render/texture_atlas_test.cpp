#include "render/texture_atlas.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "render/recording_device.hpp"

namespace plumb {
namespace {

Image filled(int width, int height, std::uint8_t value) {
    return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width * height * 4), value)};
}

TEST(Skyline, rectanglesDoNotOverlapAndStayInsideTheSquare) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        Random random{seed};
        Skyline skyline{128};
        std::vector<bool> taken(128 * 128);
        int area = 0;
        for (int i = 0; i < 400; ++i) {
            const int width = 1 + static_cast<int>(random.below(24));
            const int height = 1 + static_cast<int>(random.below(24));
            const std::optional<Skyline::Place> place = skyline.add(width, height);
            if (!place) continue;
            ASSERT_TRUE(place->x >= 0 && place->y >= 0 && place->x + width <= 128 &&
                        place->y + height <= 128);
            area += width * height;
            for (int y = place->y; y < place->y + height; ++y) {
                for (int x = place->x; x < place->x + width; ++x) {
                    ASSERT_FALSE(taken[static_cast<std::size_t>(y * 128 + x)]);
                    taken[static_cast<std::size_t>(y * 128 + x)] = true;
                }
            }
        }
        EXPECT_GT(area, 128 * 128 * 7 / 10);
    }
}

TEST(Skyline, aSquareHoldsExactlyOneRectangleOfItsSize) {
    Skyline skyline{64};
    EXPECT_FALSE(skyline.add(65, 1));
    EXPECT_TRUE(skyline.add(64, 64));
    EXPECT_FALSE(skyline.add(1, 1));
}

TEST(TextureAtlas, smallImagesShareATextureAndKeepTheirPixels) {
    RecordingDevice device;
    TextureAtlas atlas{device};
    std::vector<TextureRegion> regions;
    for (int i = 0; i < 100; ++i)
        regions.push_back(atlas.add(filled(16 + i % 5, 16 + i % 3, static_cast<std::uint8_t>(i))));
    EXPECT_EQ(atlas.textureCount(), 1u);
    for (std::size_t i = 0; i < regions.size(); ++i) {
        const TextureRegion& region = regions[i];
        const Image& page = device.image(region.texture);
        const auto at = [&](int x, int y) {
            return page.rgba[static_cast<std::size_t>((y * page.width + x) * 4)];
        };
        EXPECT_EQ(at(region.x, region.y), i);
        EXPECT_EQ(at(region.x + region.width - 1, region.y + region.height - 1), i);
    }
}

TEST(TextureAtlas, largeImagesHaveTheirOwnTextureUntilRemoved) {
    RecordingDevice device;
    TextureAtlas atlas{device};
    const TextureRegion region = atlas.add(filled(600, 20, 1));
    EXPECT_EQ(region.whole(), (Rect{0.0f, 0.0f, 600.0f, 20.0f}));
    EXPECT_EQ(atlas.textureCount(), 1u);
    atlas.remove(region);
    EXPECT_EQ(atlas.textureCount(), 0u);
}

TEST(TextureAtlas, newPixelsOfTheSameSizeKeepTheRegion) {
    RecordingDevice device;
    TextureAtlas atlas{device};
    const TextureRegion region = atlas.add(filled(16, 16, 1));
    EXPECT_EQ(atlas.replace(region, filled(16, 16, 9)), region);
    EXPECT_EQ(device.image(region.texture).rgba[0], 9);
    const TextureRegion grown = atlas.replace(region, filled(32, 16, 7));
    EXPECT_EQ(grown.width, 32);
}

TEST(TextureAtlas, anEmptyPageIsReused) {
    RecordingDevice device;
    TextureAtlas atlas{device};
    for (int round = 0; round < 20; ++round) {
        std::vector<TextureRegion> regions;
        for (int i = 0; i < 4; ++i) regions.push_back(atlas.add(filled(400, 400, 1)));
        for (const TextureRegion& region : regions) atlas.remove(region);
    }
    EXPECT_EQ(atlas.textureCount(), 1u);
}

TEST(TextureAtlas, anEmptyImageIsTheWhitePixel) {
    RecordingDevice device;
    TextureAtlas atlas{device};
    EXPECT_EQ(atlas.add({}).texture, TextureHandle{});
}

}  // namespace
}  // namespace plumb
