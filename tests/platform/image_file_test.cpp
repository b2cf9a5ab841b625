#include "platform/image_file.hpp"

#include <string>

#include <gtest/gtest.h>

#include "core/limits.hpp"
#include "core/random.hpp"
#include "tests/support/damage.hpp"

namespace plumb {
namespace {

Image noise(int width, int height, std::uint64_t seed) {
    Image image{width, height, {}};
    Random random = Random::seeded(seed);
    for (int i = 0; i < width * height * 4; ++i)
        image.rgba.push_back(static_cast<std::uint8_t>(random.below(256)));
    return image;
}

std::string bigEndian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255);
    return bytes;
}

/// Returns a PNG file with only a header that contains the size.
std::string pngHeader(std::uint32_t width, std::uint32_t height) {
    const std::string signature{"\x89PNG\r\n\x1a\n", 8};
    return signature + bigEndian(13) + "IHDR" + bigEndian(width) + bigEndian(height) +
           std::string{"\x08\x06\0\0\0", 5} + bigEndian(0) + std::string(64, '\0');
}

TEST(ImageFile, anImageWrittenAsPngReadsBackTheSame) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        const Image image = noise(1 + static_cast<int>(seed) * 3, 40 - static_cast<int>(seed), seed);
        const Result<std::string> png = encodePng(image);
        ASSERT_TRUE(png.ok());

        const Result<Image> read = decodeImage(*png, "x.png");

        ASSERT_TRUE(read.ok()) << read.error().text();
        EXPECT_EQ(*read, image);
        EXPECT_EQ(*readImageSize(*png, "x.png"), (ImageSize{image.width, image.height}));
    }
}

TEST(ImageFile, anImageWhosePixelsDoNotMatchItsSizeIsNotWritten) {
    EXPECT_FALSE(encodePng(Image{}).ok());
    EXPECT_FALSE(encodePng(Image{2, 2, {1, 2, 3}}).ok());
    EXPECT_FALSE(encodePng(Image{-1, -1, {1, 2, 3, 4}}).ok());
}

TEST(ImageFile, emptyTruncatedAndUnsupportedFilesAreRejectedWithAReason) {
    const std::string png = *encodePng(noise(16, 16, 1));
    const std::string broken[] = {"",
                                  "x",
                                  "not a picture",
                                  std::string(100, '\0'),
                                  png.substr(0, 7),
                                  png.substr(0, 8),
                                  png.substr(0, 20),
                                  png.substr(0, png.size() / 2),
                                  "GIF89a\x10\0\x10\0",
                                  "BM",
                                  "\xff\xd8\xff",
                                  "<svg width='10' height='10'/>"};
    for (const std::string& bytes : broken) {
        const Result<Image> result = decodeImage(bytes, "bad.png");
        ASSERT_FALSE(result.ok()) << bytes.size();
        EXPECT_EQ(result.error().where, "bad.png");
        EXPECT_FALSE(result.error().what.empty());
        EXPECT_FALSE(result.error().remedy.empty());
    }
}

TEST(ImageFile, theSizeIsReadFromHeadersOfAllFormats) {
    const std::string jpeg{"\xff\xd8\xff\xe0\x00\x04zz\xff\xc0\x00\x11\x08\x00\x20\x00\x40\x03", 18};
    EXPECT_EQ(*readImageSize(jpeg, "x"), (ImageSize{64, 32}));
    std::string bmp = "BM" + std::string(12, '\0') + std::string{"\x28\0\0\0\x07\0\0\0\xf7\xff\xff\xff", 12};
    EXPECT_EQ(*readImageSize(bmp, "x"), (ImageSize{7, 9}));
    for (std::size_t length = 0; length + 1 < jpeg.size(); ++length) {
        EXPECT_FALSE(readImageSize(jpeg.substr(0, length), "x").ok()) << length;
    }
}

TEST(ImageFile, sizesBeyondTheLimitAreRejectedByTheHeaderAlone) {
    const auto side = static_cast<std::uint32_t>(limits::kImageSide);
    EXPECT_TRUE(readImageSize(pngHeader(side, 1), "x").ok());
    EXPECT_TRUE(readImageSize(pngHeader(1, side - 1), "x").ok());
    EXPECT_FALSE(readImageSize(pngHeader(side + 1, 1), "x").ok());
    EXPECT_FALSE(readImageSize(pngHeader(1, side + 1), "x").ok());
    EXPECT_FALSE(readImageSize(pngHeader(0, 1), "x").ok());
}

TEST(ImageFile, decompressionBombsAreRejectedByTheHeaderAlone) {
    for (const auto& [width, height] : {std::pair{16384u, 16384u},
                                        {16384u, 8192u},
                                        {8192u, 8192u},
                                        {0x7fffffffu, 1u},
                                        {0xffffffffu, 0xffffffffu},
                                        {100000u, 100000u}}) {
        EXPECT_FALSE(decodeImage(pngHeader(width, height), "bomb.png").ok()) << width;
    }
}

TEST(ImageFile, aJpegWithTooManyScansIsRejected) {
    std::string jpeg{"\xff\xd8\xff\xc2\x00\x11\x08\x10\x00\x10\x00\x03\x01\x11\x00\x02\x11\x01\x03\x11\x01",
                     21};
    for (int i = 0; i < 1000; ++i) jpeg += std::string{"\xff\xda\x00\x08\x01\x01\x00\x00\x00\x00", 10};

    const Result<Image> result = decodeImage(jpeg, "bomb.jpg");

    ASSERT_FALSE(result.ok());
    EXPECT_NE(result.error().what.find("scans"), std::string::npos) << result.error().text();
}

TEST(ImageFile, randomBytesAndMutationsNeverCrash) {
    const std::string png = *encodePng(noise(12, 9, 3));
    Random random = Random::seeded(9);
    for (int i = 0; i < 5000; ++i) {
        std::string bytes = test::withWrongBytes(png, random, 4);
        if (random.below(3) == 0) bytes.resize(random.below(static_cast<std::uint32_t>(bytes.size())));
        const Result<Image> result = decodeImage(bytes, "x");
        EXPECT_TRUE(!result.ok() || result->rgba.size() <= limits::kImageBytes);
    }
}

}  // namespace
}  // namespace plumb
