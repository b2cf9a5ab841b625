#include "codec/pack.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "core/text.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

using Files = std::vector<std::pair<std::string, std::string>>;

/// Up to 40 files: empty ones, repeated ones, ones that compress and ones that do not.
Files randomFiles(std::uint64_t seed) {
    Random random{seed};
    Files files;
    const int count = static_cast<int>(random.below(41));
    for (int i = 0; i < count; ++i) {
        std::string bytes;
        const std::uint32_t size = random.below(3001), kind = random.below(4);
        for (std::uint32_t k = 0; kind > 0 && k < size; ++k)
            bytes += static_cast<char>(kind == 1 ? random.below(256) : 'a' + k / 100 % 3);
        if (kind == 3 && !files.empty()) bytes = files.front().second;
        files.emplace_back(format("folder{}/file{}.bin", random.below(6), i), std::move(bytes));
    }
    return files;
}

TEST(Pack, containsWhatWasWritten) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Files files = randomFiles(seed);
        const auto pack = Pack::open(writePack(files), "pack");
        ASSERT_TRUE(pack) << pack.error().text();
        std::sort(files.begin(), files.end());
        ASSERT_EQ((*pack)->paths().size(), files.size()) << seed;
        for (std::size_t i = 0; i < files.size(); ++i) {
            EXPECT_EQ((*pack)->paths()[i], files[i].first) << seed;
            const Result<std::string> bytes = (*pack)->read(i);
            ASSERT_TRUE(bytes) << bytes.error().text();
            EXPECT_EQ(*bytes, files[i].second) << seed;
        }
    }
}

TEST(Pack, hasTheSameBytesForFilesInAnyOrder) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const Files files = randomFiles(seed);
        EXPECT_EQ(writePack(files), writePack({files.rbegin(), files.rend()})) << seed;
    }
}

TEST(Pack, containsEqualFilesOnce) {
    Random random{7};
    std::string noise;
    for (int i = 0; i < 10'000; ++i) noise += static_cast<char>(random.below(256));
    const std::size_t one = writePack({{"a", noise}}).size();
    EXPECT_LT(writePack({{"a", noise}, {"b", noise}, {"c", noise}}).size(), one + 100);
}

TEST(Pack, compressesOnlyWhatGetsSmaller) {
    const std::string text(100'000, 'x');
    EXPECT_LT(writePack({{"a", text}}).size(), 300u);
    Random random{7};
    std::string noise;
    for (int i = 0; i < 10'000; ++i) noise += static_cast<char>(random.below(256));
    EXPECT_LT(writePack({{"a", noise}}).size(), noise.size() + 200);
}

TEST(Pack, refusesEveryDamageOrReadsTheSame) {
    const Files files = randomFiles(3);
    const std::string whole = writePack(files);
    Files sorted = files;
    std::sort(sorted.begin(), sorted.end());
    int refused = 0;
    for (std::uint64_t seed = 1; seed <= 5'000; ++seed) {
        Random random{seed};
        const std::string bytes = test::withWrongBytes(whole, random);
        const auto pack = Pack::open(bytes, "pack");
        if (!pack) {
            EXPECT_FALSE(pack.error().what.empty());
            ++refused;
            continue;
        }
        for (std::size_t i = 0; i < (*pack)->paths().size(); ++i) {
            const Result<std::string> read = (*pack)->read(i);
            if (!read) {
                ++refused;
            } else {
                EXPECT_EQ(*read, sorted[i].second) << seed;
            }
        }
    }
    EXPECT_GT(refused, 3'000);
}

TEST(Pack, refusesPathsThatLeaveTheFolder) {
    for (const char* path : {"../x", "/x", "a/../../x", "c:x", "a\\b", ""}) {
        const auto pack = Pack::open(writePack({{path, "bytes"}}), "pack");
        ASSERT_FALSE(pack) << path;
        EXPECT_NE(pack.error().what.find(path), std::string::npos);
    }
}

TEST(Pack, refusesAnotherVersion) {
    std::string bytes = writePack({{"a", "b"}});
    bytes[8] = 2;
    const auto pack = Pack::open(bytes, "pack");
    ASSERT_FALSE(pack);
    EXPECT_NE(pack.error().what.find("version of the pack is 2, expected 1"), std::string::npos);
}

TEST(Pack, isReadFromAFile) {
    const test::TemporaryFolder folder;
    const Files files = randomFiles(11);
    ASSERT_TRUE(writeFile(folder.path / "game.pack", writePack(files)));
    const auto pack = Pack::open(folder.path / "game.pack");
    ASSERT_TRUE(pack) << pack.error().text();
    for (const auto& [path, bytes] : files) {
        const auto paths = (*pack)->paths();
        const auto at = std::find(paths.begin(), paths.end(), path);
        ASSERT_NE(at, paths.end());
        const Result<std::string> read = (*pack)->read(static_cast<std::size_t>(at - paths.begin()));
        ASSERT_TRUE(read);
        EXPECT_EQ(*read, bytes);
    }
    const auto missing = Pack::open(folder.path / "other.pack");
    EXPECT_FALSE(missing);
}

// The list of files lies behind the contents; the bytes between them take no place on the disk.
TEST(Pack, isReadBeyond4GiB) {
    const test::TemporaryFolder folder;
    const Files files{{"a.txt", "first"}, {"b.txt", std::string(5000, 'x')}};
    const std::string whole = writePack(files);
    std::uint32_t tableBytes = 0;
    for (std::size_t i = 0; i < 4; ++i)  // in the header, see pack.hpp
        tableBytes |= static_cast<std::uint32_t>(static_cast<unsigned char>(whole[12 + i])) << (8 * i);
    const std::size_t contents = whole.size() - tableBytes;
    {
        std::ofstream file{folder.path / "game.pack", std::ios::binary};
        file.write(whole.data(), static_cast<std::streamsize>(contents));
        file.seekp(std::streamoff{5} << 30);
        file.write(whole.data() + contents, static_cast<std::streamsize>(tableBytes));
        if (!file.flush()) GTEST_SKIP() << "the disk takes no file of this size";
    }
    const auto pack = Pack::open(folder.path / "game.pack");
    ASSERT_TRUE(pack) << pack.error().text();
    ASSERT_EQ((*pack)->paths().size(), files.size());
    EXPECT_TRUE((*pack)->read(0));
}

}  // namespace
}  // namespace plumb
