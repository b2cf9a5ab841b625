#include "codec/compression.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "codec/base64.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "tests/support/damage.hpp"

namespace plumb {
namespace {

constexpr std::size_t kRoom = 1 << 20;

/// Returns the 1,200 map cells that the compressed texts below contain.
std::string expectedCells() {
    std::string bytes;
    std::uint32_t state = 1;
    for (int i = 0; i < 1200; ++i) {
        state = state * 1664525u + 1013904223u;
        const std::uint32_t cell = i % 3 == 0 ? state >> 28 : i % 40 < 9 ? 0x80000007u : 0u;
        for (int byte = 0; byte < 4; ++byte) bytes += static_cast<char>(cell >> (8 * byte) & 255);
    }
    return bytes;
}

using Unpack = Result<std::string> (*)(std::string_view, std::size_t, std::string_view);

struct Packed {
    const char* name;
    Unpack unpack;
    const char* base64;
};

const Packed kPacked[] = {
    {"zlib", unpackZlib,
     "eNqVmItu5SAMRJ0AeQHJL/fTq13t1bUsTpiNVGmUUhj8GE+azGw3+/nzUx1uDl/2fU6HH4f9msXh1eHN4Rv22R32fFbAno9/"
     "OrxvcBdacwG3+/vuL4cPn83h8g/H+27C/gbxTMA/xs2v+fDpDh8O07l+n+JwBg4UzwKxXYCPBc6jOyo12YV7dcjL6fLred4D"
     "zvHcBmdd0BcZ8kt12MJ636cj3CA+Ge6e4awNcrq9rI+9ELl1iEmHGFahHp6XWMV9PvU/6hHfv1nQmUOI4Ql32YD/CZrse+SB"
     "fZLNnwM0uQga7rkl4JYEfbgAV6Gvy6SvP/GZ6XMR+NyCNm5CnRQhhg3ym4GPQZxvYV7vUA8NdK+CNyA9ob5egFt9mRfxfaw3"
     "n9/sft+F+WsC5yTMoDhPR/n1GrgIHqlCjg5Bf84XnRzpXgVupLd0rgkabpMYRm4jrxXPJe1KENvzP2dcnEGx3qLm0MzKgn82"
     "wTM8L5o56osU+nrmT4rg9zbBu9bB+7f8NpffE/LYgc8CWNHq6IVGc60EPPMnB3AgX00etYUaHvFJMDuKEIcVOKwQZ9Jz758b"
     "6Ex3+SUOD2DFPx/wtwb+2aB/lbOKOOtnnjDGYdQXFb7dLsFrEX/yFcck76NeiDxVD0Bzfxe4ETbwMCbEsAk+hGZrgTjvYc3o"
     "fxoZ/NU1+ZZ50+1H+K68BnUYuRn0L/XIKnjOR9Bk8tK/eE5qsg=="},
    {"zlib with fixed codes", unpackZlib,
     "eAFjZmBgYGdgaABhbiQ2DxKbiwEBOJHY/EhsZDWMSGwmJDYbEpsPhznsSGxk9zDhYCO7Bxnw4hDnweEXXGq4cLiNDyEGdgPM"
     "PWxIbFYoG92/bESYz4AjPJlxuB893JDVwNzDi8TmQGLjshfZHFYkNgsON+AKT1YcYcuIwz0MaG7G5kdi0iQvEf7ixREvnEjx"
     "i+xOPixuRreXB4ddXDjyBQuO+MWVDnnQ1CPnU2xsHhzhw4LD7yw47GLDEadseNSj5wV0t/HiCBNeHGHITUR64McTVujmwNI/"
     "tjyCnH9ZiChnOIgIQ04cfmHD4X5OHGUych7hx2EOMwNhwIGjTGYlogxHdhszDrcxE1E+cOFgcxORr1kJ5GtY+BAqn1mJcA8f"
     "EWUjGxHphJWIMOTBEb8sONzDgCOc+Yior9lxpAceHOUeN462Aa7yBFe+ZsThNm489QW6OHp6Q45fFiR5XiLqXwYi3MxMRB2E"
     "Xp9ii1/kMpCRiDYSN4444iCi/OHEU05iK/e4cbgNV3mLy14GIspwBgJhiO42bG0tdHtxlV3MOMKWk8Q6Dr0OQk9v6GUOrjqL"
     "hYj2MwMRbQZ+PGUmtnzBjJavCbVPWIlo77ER0XblxiKOL355kOKXE0c88uJwDyMONjFlNXpbCFu9xorGJtQ+4cDhBlztalxt"
     "VB60NIzNPcw46g5WIsKBCYcbmHCEM67yHLn9zIOjnOFFil9cbuDHwSam/cyBQy8DjvYzA478S4xdrETW9YTahOjhgC1fcOPo"
     "u3ER0dbC5X5c7QoOAvGOLS+gu5PYNgCuep+dCLfhYjPgaMMwEBGGPES0Q3DVraw4wpkdTQ22MQ0WHO0rLgJ9GXzlNj8R/Uou"
     "LOkQ3W0MOPIvrjzCRESbk5+IMhlXWxoAeE5qsg=="},
    {"gzip", unpackGzip,
     "H4sIAAAAAAAAA42XDW/CMAxEw0dboKX9y/x01GkRbyc/VkuTrCxNLmf7bC6ttam11/43w1/gP9rH7vA3+Nxzgn+GP8Jf5ZwJ"
     "PvGcxSce2lPWF/j2LffwXcS2ftZ+MHQ8I/zh1+f+3ciDnU8jnxfBn7xxT8fzhH+Db/fynAH+VTAYn/yW3J4ETwvM3YjzSE5a"
     "Dsyyh3HpZ+4YiHMtMOe9fCPvImbWBflkfC0PuX5pf+u08rmfOHnvKOuL7BlkPfdnLSQ28k9OuD6Lb/lgsSC3/Zye/1WNsH7J"
     "CY04b/CNQ+Yq30IOiZ/1S00G9tcm5/C9ZsRMjWJ8TcOJjXnYYp37K3uIT36sromzquvOz3/6zHMMD/kxbSQ/NMNsHDLWVrPE"
     "Q7vLHuvXrCPmAzFQ99iXeY7pidU1+xqxkdvsF7me+cb4XvF/03nipxlm5rP1oOynVXypgXyXzUjk5HbAtx6dOlnpHuNLbKa3"
     "di/NNJxWcZjYqlkr7zXtYuzILe890uOyB2W+peZYzyJmm59pNjNY7ZjuMQ/Jg80nqVeVb7rHt8zF+rf4dv3JuxhH1ib3nMQ/"
     "otU5C1V9bQi/eqPp6iA+Y2ozKvWQmkw8jC9zw+41rZ5lnTybnnN+Zh95Fv43DJv4R+Zncs5vaTa3sHaO3EU+v/X6bjYTJg9V"
     "XVCfTZNt1jL8NleQwyruVS0kzv6W/HY30wfywzcaNvM7xpxhuG4cLuJXeZ7fMu7keYo9zLGqj9gsWv2W2c10234T2fk9DxNb"
     "a3X9Wo1w3WZO+/1ixvx5A60AJ73AEgAA"},
    {"zstd", unpackZstd,
     "KLUv/WTAERUOAHYTLRCwJQ8MwzAMdmukCGFlSSlTJwAoACcAVrZklLM7JKnbF2is5xCF9Pqx4jykAWWYe9zzJTRgEu/jczX4"
     "w/8JcqbHarBYKrAXsgEEaKf4VkCWtRa3Zh5nTAr4WH/bFJeOTzzbGVRZOCpW1bVUF7ROdqsI5MENvSGWpDbJI5vUynCEMOD1"
     "dBm4k+5OIwPmcPxbhxQSy+2SlKnE2M0DvwPCarBoFR5AQ0dFMVzkGpLuG5Ju4cVglIGaqCH1dgNxBylImwMSQBFUGAEDuSpI"
     "Uan2M7oh8OHKdpbB+02AAUhxddfEd1TNxLn5y3/fef1cD4L+1wMFq0Nc9k5ZMQi3fmH4p+AdX4SXGexsXVjA9MweLxuvC8U/"
     "MdexMyosUt3ETy9fHzCt4u6YKAuyP2L30GsWn0vtB8F/SnLj2Ut+SeToAwIO9t83DgSUCrQrjLMaJIf+5Zr9hCtiIHs4vAib"
     "pZ1ucTT55osyaurHd9dmxF52CenoygcTTQ/dKfI/nMfkH0j4mWTGLx4x+tKxb+IvfzVfBbuAOhDcxOLeLkP0+WD0SzKIwhc+"
     "VX38YSoflssD/5GZoBbsGYepaqQqge+LvihVAWungR8="},
    {"zstd, highest level, no sum", unpackZstd,
     "KLUv/WDAEU0MAEaWMhDA5QH////fZWVJpFwhkS0FLAAtAC0AvZmzuSSp20EAND53Hh9sHan0gVEPB1zayy5uj3s+il4LE5CN"
     "f66O/8Z//yc3pi9YbXCjVLHhLVBQD9atxMua65rH+aCJCB/rL7bpKZyKT2c7T5Uly6xsbwHVJZaVqsJp1cleACAP7gB6QyxJ"
     "Mab9g6TTptMfxUiRId/1FPIAdyI9qIH85Tx860shvthzu0QnSeqmEsH+4g/iVgGLVnH40PMUxXCRa0h6OgxJtxjzImAUfQWB"
     "Pqgh5NfPEaOUNOkRJAhCgBCYo+S5/BwghdLSoW62T2Ib3ZEvXvfW7gy4hYPjLTknF7u/H3UkgH3NRj5CrL3R8fSH+CvuoCjl"
     "0h5q+Ln4OKFt16/uVk2zwDcXr1fOb1tWxkWZ2r6TLieWe7LZy/h+Z2zIih8vezLl8YDbf+J3yct0KFjReIdXeA2Q7opUnQqn"
     "z3W8ONzGjxjEyaZl6tyB2jk7omuTzPPEEXLiC+Dy7RJljIOtBvBk+E6jVQ=="},
    {"zstd, fast", unpackZstd,
     "KLUv/WTAEf0TADQVAwAAAAcAAIAHAACACwwKAAkADwAKAAEAAgAGAA4ADwAHAAIADQAMCQAMCgkGBQ4GCgcAAQMJCw0ICwUE"
     "CQAFDAGADQcKDw0LBgkOCA8MCwoCBAMMCgwDCgoEBgQMBgUGCgINCwcKDwwDCw0FDQgEBg8MAA8GAwAACA4FAgYJAwMJAAoK"
     "Cw8NBQsNDwYFBQoKDgsFBgANBQkDDA8EDgAJDg8HCAsEBgINAQ8LDAEABgQNBgoAAg0DCgkDCgYOCwgICAQJCg0LBwoIBAsL"
     "AAkHCQUCAw4JBgUGCwQPCgEAAgQPCwoCCQkACwEJCQMNCQEBBQYABgAHAACACwcIBQsMDgUDBQYCCwIJDQwNBgIPAgQDCA8A"
     "DwIEAwUNCQwGAgkLBwoJAAQOCA0FCwINAQsMBw4IDgoMDAEKAAAAAAcCCgMLBQwKCgYCAA0CBAIKBw8GAAANgaeoIe0L+wZR"
     "B5GkTQcRYIQKIga9qTIdBFoivfCpi8dS0S5QwS8DbMWfyIqlwUWFWSMql6DXU+ZhAKb+IWfwsoolowCebxfWeOpfOkGZMoOX"
     "y+zTC8afIm4fOL123vgjw79O0ftEQnMQBOfPHN/85EIjx4DbApW66BMvyQ7kP+DjMHOmgMlIayHmRV6/o0G7hAfjQwTvuDEz"
     "DSDorRm88eNlKkKAtuKPs2CjQiHCvcMM5D5qD1DWbQWKRSE6iGgWDI8N372xnciWLm3yBy4GhOaPKHURX7cSknFQEnvewPJs"
     "NXCjn82cPXhv9UxEM6wI8A6nCIRzbYhx2DQjJv6DHfnCZleCkQACCvnt3nw2htN+2M8T7910Io1HH/3oo48++tFHo0dR2d85"
     "q2ungR8="},
};

TEST(UnpackTest, everyCompressionFormatYieldsTheSameCells) {
    const std::string expected = expectedCells();
    for (const Packed& packed : kPacked) {
        SCOPED_TRACE(packed.name);
        const Result<std::string> bytes =
            packed.unpack(*bytesFromBase64(packed.base64, "test"), kRoom, "test");
        ASSERT_TRUE(bytes.ok()) << bytes.error().text();
        EXPECT_TRUE(*bytes == expected);
    }
}

TEST(UnpackTest, outputBeyondTheLimitIsRejected) {
    const std::string expected = expectedCells();
    for (const Packed& packed : kPacked) {
        SCOPED_TRACE(packed.name);
        const std::string bytes = *bytesFromBase64(packed.base64, "test");
        EXPECT_TRUE(packed.unpack(bytes, expected.size(), "test").ok());
        EXPECT_FALSE(packed.unpack(bytes, expected.size() - 1, "test").ok());
        EXPECT_FALSE(packed.unpack(bytes, 0, "test").ok());
    }
}

TEST(UnpackTest, everyTruncationIsAnErrorWithWhereWhatAndRemedy) {
    for (const Packed& packed : kPacked) {
        SCOPED_TRACE(packed.name);
        const std::string bytes = *bytesFromBase64(packed.base64, "test");
        for (std::size_t length = 0; length < bytes.size(); ++length) {
            const Result<std::string> result = packed.unpack(bytes.substr(0, length), kRoom, "map.tmx");
            ASSERT_FALSE(result.ok()) << length;
            EXPECT_EQ(result.error().where, "map.tmx");
            EXPECT_FALSE(result.error().what.empty());
            EXPECT_FALSE(result.error().remedy.empty());
        }
    }
}

TEST(UnpackTest, mutatedDataNeverCrashesAndNeverExceedsTheLimit) {
    for (const Packed& packed : kPacked) {
        SCOPED_TRACE(packed.name);
        const std::string original = *bytesFromBase64(packed.base64, "test");
        Random random = Random::seeded(7);
        for (int i = 0; i < 1000; ++i) {
            const std::string bytes = test::withWrongBytes(original, random, 4);
            const Result<std::string> result = packed.unpack(bytes, kRoom, "test");
            EXPECT_LE(result.ok() ? result->size() : 0u, kRoom);
        }
    }
}

TEST(PackTest, compressedDataIsRestored) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const std::uint32_t kinds = 1 + random.below(256);
        std::string bytes;
        const std::size_t size = seed == 0 ? 0 : random.below(100'000);
        while (bytes.size() < size) {
            const auto letter = static_cast<char>(random.below(kinds));
            bytes.append(1 + random.below(300), letter);
        }
        const std::string packed = packZlib(bytes);
        const Result<std::string> unpacked = unpackZlib(packed, bytes.size(), "packed");
        ASSERT_TRUE(unpacked.ok()) << unpacked.error().text();
        EXPECT_TRUE(*unpacked == bytes);
        EXPECT_TRUE(bytes.empty() || !unpackZlib(packed, bytes.size() - 1, "packed").ok());
    }
}

TEST(PackTest, repeatedBytesCompressWell) { EXPECT_LT(packZlib(std::string(65'536, 'x')).size(), 200u); }

// ---- the formats, written by hand from their specifications ---------------------------------------

std::string lowBytes(std::uint32_t word, int count) {
    std::string bytes;
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(word >> (8 * i) & 255);
    return bytes;
}

/// RFC 1950, section 9, in the order of the file: high byte first.
std::string adler32(std::string_view bytes) {
    std::uint32_t a = 1, b = 0;
    for (const char c : bytes) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    const std::string low = lowBytes(b << 16 | a, 4);
    return {low.rbegin(), low.rend()};
}

/// RFC 1952, section 8, bit by bit.
std::string crc32(std::string_view bytes) {
    std::uint32_t crc = 0xffffffffu;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
    }
    return lowBytes(~crc, 4);
}

/// RFC 1951, section 3.2.4: blocks without compression.
std::string storedBlocks(std::string_view bytes) {
    std::string out;
    do {
        const std::string_view part = bytes.substr(0, 65'535);
        bytes.remove_prefix(part.size());
        const auto length = static_cast<std::uint32_t>(part.size());
        out += static_cast<char>(bytes.empty() ? 1 : 0);
        out += lowBytes(length, 2) + lowBytes(~length, 2);
        out += part;
    } while (!bytes.empty());
    return out;
}

std::string storedZlib(std::string_view bytes) { return "\x78\x01" + storedBlocks(bytes) + adler32(bytes); }

std::string storedGzip(std::string_view bytes) {
    using namespace std::string_literals;
    return "\x1f\x8b\x08\0\0\0\0\0\0\xff"s + storedBlocks(bytes) + crc32(bytes) +
           lowBytes(static_cast<std::uint32_t>(bytes.size()), 4);
}

/// RFC 8878, section 3.1.1: a frame of blocks of at most 1,000 bytes without compression.
/// @param isSized  the header contains the number of bytes, which is at most 65,791
std::string storedZstd(std::string_view bytes, bool isSized) {
    std::string out = "\x28\xb5\x2f\xfd";
    if (isSized && bytes.size() < 256) {
        out += "\x20" + lowBytes(static_cast<std::uint32_t>(bytes.size()), 1);
    } else if (isSized) {
        out += "\x60" + lowBytes(static_cast<std::uint32_t>(bytes.size() - 256), 2);
    } else {
        out += std::string(2, '\0');  // a window of 1 KiB
    }
    do {
        const std::string_view part = bytes.substr(0, 1000);
        bytes.remove_prefix(part.size());
        out += lowBytes(static_cast<std::uint32_t>(part.size() << 3) | (bytes.empty() ? 1u : 0u), 3);
        out += part;
    } while (!bytes.empty());
    return out;
}
std::string sizedZstd(std::string_view bytes) { return storedZstd(bytes, true); }
std::string unsizedZstd(std::string_view bytes) { return storedZstd(bytes, false); }

std::string randomBytes(std::size_t count, std::uint64_t seed) {
    Random random = Random::seeded(seed);
    std::string bytes;
    while (bytes.size() < count) bytes += static_cast<char>(random.below(256));
    return bytes;
}

std::string errorOf(const Result<std::string>& result) {
    return result.ok() ? format("no error, but {} bytes", result->size()) : result.error().text();
}

/// The whole text of an error of the data "map.tmx".
std::string damagedText(std::string_view what) {
    return format("map.tmx: {}; the file is damaged or too large; export it again", what);
}

struct Format {
    const char* name;
    std::string (*pack)(std::string_view);
    Unpack unpack;
};

constexpr std::array<Format, 4> kFormats{{{"zlib", storedZlib, unpackZlib},
                                          {"gzip", storedGzip, unpackGzip},
                                          {"zstd", unsizedZstd, unpackZstd},
                                          {"zstd with its size", sizedZstd, unpackZstd}}};

TEST(UnpackTest, dataOfEverySizeIsUnpackedUpToTheLimitAndNotBeyond) {
    for (const Format& packing : kFormats) {
        SCOPED_TRACE(packing.name);
        for (const std::size_t size : {0, 1, 2, 255, 256, 4095, 4096, 4097, 8191, 8192, 8193, 12'288, 16'383,
                                       16'384, 16'385, 65'535}) {
            SCOPED_TRACE(size);
            const std::string bytes = randomBytes(size, size);
            const std::string packed = packing.pack(bytes);
            for (const std::size_t limit : {size, size + 1, 2 * size, kRoom}) {
                const Result<std::string> unpacked = packing.unpack(packed, limit, "map.tmx");
                ASSERT_TRUE(unpacked.ok()) << limit << ": " << unpacked.error().text();
                ASSERT_TRUE(*unpacked == bytes) << limit;
            }
            if (size == 0) continue;
            for (const std::size_t limit : {size - 1, size / 2, std::size_t{0}}) {
                const std::string error = errorOf(packing.unpack(packed, limit, "map.tmx"));
                const bool isSeenLate = packing.pack == unsizedZstd;
                EXPECT_EQ(
                    error,
                    damagedText(isSeenLate ? format("the packed data is damaged or unpacks to more than "
                                                    "{} bytes: Destination buffer is too small",
                                                    limit)
                                           : format("the packed data unpacks to more than {} bytes", limit)));
            }
        }
    }
}

TEST(UnpackTest, memoryIsTakenForTheContentAndNotBeyondTheLimit) {
    for (const Format& packing : {kFormats[0], kFormats[1]}) {
        SCOPED_TRACE(packing.name);
        const std::string packed = packing.pack(randomBytes(100, 1));
        EXPECT_LE(packing.unpack(packed, kRoom, "test")->capacity(), 8192u)
            << "a generous limit costs nothing";
        EXPECT_LE(packing.unpack(packed, 100, "test")->capacity(), 256u) << "a tight one is not exceeded";
    }
}

TEST(UnpackTest, truncatedDataIsReportedAsTruncated) {
    const std::string bytes = randomBytes(5000, 3);
    for (const Format& packing : kFormats) {
        SCOPED_TRACE(packing.name);
        const std::string packed = packing.pack(bytes);
        const bool isZstd = packing.unpack == unpackZstd;
        EXPECT_EQ(errorOf(packing.unpack("", kRoom, "map.tmx")), damagedText("the packed data is truncated"));
        for (std::size_t length = 1; length < packed.size(); length += length < 20 ? 1 : 97) {
            const std::string error = errorOf(packing.unpack(packed.substr(0, length), kRoom, "map.tmx"));
            EXPECT_EQ(error,
                      damagedText(isZstd ? "the packed data is damaged or unpacks to more than 1048576 "
                                           "bytes: Src size is incorrect"
                                         : "the packed data is truncated"))
                << length;
        }
    }
}

TEST(UnpackTest, aDamagedPartIsReportedWithItsKind) {
    using namespace std::string_literals;
    const auto withByte = [](std::string bytes, std::size_t at, char value) {
        bytes[at] = value;
        return bytes;
    };
    const std::string zlib = storedZlib("abc"), gzip = storedGzip("abc");
    const struct {
        Unpack unpack;
        std::string packed;
        std::string what;
    } cases[] = {
        {unpackZlib, "abc", "incorrect header check"},
        {unpackZlib, gzip, "incorrect header check"},
        {unpackZlib, withByte(zlib, 2, '\x07'), "invalid block type"},
        {unpackZlib, withByte(zlib, 3, '\x04'), "invalid stored block lengths"},
        {unpackZlib, withByte(zlib, zlib.size() - 1, 'x'), "incorrect data check"},
        {unpackGzip, "abc", "incorrect header check"},
        {unpackGzip, zlib, "incorrect header check"},
        {unpackGzip, withByte(gzip, 10, '\x07'), "invalid block type"},
        {unpackGzip, withByte(gzip, gzip.size() - 8, 'x'), "incorrect data check"},
        {unpackGzip, withByte(gzip, gzip.size() - 4, 'x'), "incorrect length check"},
    };
    for (const auto& test : cases) {
        EXPECT_EQ(errorOf(test.unpack(test.packed, 100, "map.tmx")),
                  damagedText("the packed data is damaged: " + test.what));
    }
    EXPECT_EQ(errorOf(unpackZlib("\x78\x20"
                                 "dict....",
                                 100, "map.tmx")),
              damagedText("zlib data with a preset dictionary is not supported"));
    EXPECT_EQ(errorOf(unpackZstd(std::string(100, 'x'), 100, "map.tmx")),
              damagedText("the packed data is damaged or unpacks to more than 100 bytes: "
                          "Unknown frame descriptor"));
}

TEST(UnpackTest, whatFollowsTheStreamIsIgnoredAndFramesOfZstdAreJoined) {
    const auto unpacked = [](const Result<std::string>& result) {
        return result.ok() ? *result : result.error().text();
    };
    EXPECT_EQ(unpacked(unpackZlib(storedZlib("abc") + "more", 3, "test")), "abc");
    EXPECT_EQ(unpacked(unpackGzip(storedGzip("abc") + storedGzip("def"), 3, "test")), "abc");
    const std::string two = sizedZstd("abc") + unsizedZstd("def");
    EXPECT_EQ(unpacked(unpackZstd(two, 6, "test")), "abcdef");
    EXPECT_FALSE(unpackZstd(two, 5, "test").ok());
}

TEST(PackTest, theResultIsAZlibStreamWithTheChecksumOfItsContent) {
    for (const std::size_t size : {0, 1, 3, 100, 5000}) {
        SCOPED_TRACE(size);
        const std::string bytes = randomBytes(size, size + 1);
        const std::string packed = packZlib(bytes);
        ASSERT_GE(packed.size(), 6u);
        EXPECT_EQ(packed[0], '\x78') << "RFC 1950: deflate with a window of 32 KiB";
        EXPECT_EQ((0x78 * 256 + static_cast<unsigned char>(packed[1])) % 31, 0);
        EXPECT_EQ(packed.substr(packed.size() - 4), adler32(bytes));
    }
}

}  // namespace
}  // namespace plumb
