#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

/// Files whose content is their path in capital letters.
class Capitals : public FileSource {
public:
    explicit Capitals(std::vector<std::string> paths) : paths_{std::move(paths)} {}
    [[nodiscard]] std::span<const std::string> paths() const override { return paths_; }
    [[nodiscard]] Result<std::string> read(std::size_t index) const override {
        std::string text = paths_[index];
        for (char& c : text) {
            if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
        }
        return text;
    }

private:
    std::vector<std::string> paths_;
};

/// A folder with the file "disk.txt", in which files are mounted.
class MountedFiles : public testing::Test {
protected:
    MountedFiles() {
        EXPECT_TRUE(writeFile(root() / "disk.txt", "disk"));
        EXPECT_TRUE(writeFile(root() / "both.txt", "disk"));
        mountFiles(root(), std::make_shared<Capitals>(std::vector<std::string>{
                               "a/b/c.txt", "a/bc.txt", "a/x.lua", "both.txt", "top.txt"}));
    }
    ~MountedFiles() override { mountFiles(root(), nullptr); }
    [[nodiscard]] Path root() const { return folder_.path; }

private:
    test::TemporaryFolder folder_;
};

TEST_F(MountedFiles, areReadLikeThoseOnTheDisk) {
    for (const Path& path : {root() / "a/b/c.txt", root() / "a/./b/../b/c.txt"}) {
        const Result<std::string> text = readFile(path);
        ASSERT_TRUE(text) << text.error().text();
        EXPECT_EQ(*text, "A/B/C.TXT");
    }
    EXPECT_EQ(*readFile(root() / "disk.txt"), "disk");
}

TEST_F(MountedFiles, comeAfterThoseOnTheDiskOrBefore) {
    EXPECT_EQ(*readFile(root() / "both.txt"), "disk");
    mountFiles(root(), std::make_shared<Capitals>(std::vector<std::string>{"both.txt"}), Preferred::Mounted);
    EXPECT_EQ(*readFile(root() / "both.txt"), "BOTH.TXT");
    EXPECT_EQ(*readFile(root() / "disk.txt"), "disk");
}

// A game without mods does not read what players put into its folders, but replays beside the program.
TEST_F(MountedFiles, hideWhatElseIsInTheirFoldersIfTheyArePreferred) {
    ASSERT_TRUE(writeFile(root() / "a/extra.txt", "disk"));
    EXPECT_TRUE(fileExists(root() / "a/extra.txt"));
    EXPECT_EQ(filesBelow(root() / "a", ".txt").size(), 3u);
    mountFiles(root(), std::make_shared<Capitals>(std::vector<std::string>{"a/b/c.txt", "top.txt"}),
               Preferred::Mounted);
    EXPECT_FALSE(fileExists(root() / "a/extra.txt"));
    EXPECT_FALSE(readFile(root() / "a/extra.txt"));
    EXPECT_EQ(fileStamp(root() / "a/extra.txt"), 0u);
    EXPECT_EQ(filesBelow(root() / "a", ".txt"), (std::vector<std::string>{"b/c.txt"}));
    EXPECT_TRUE(folderExists(root() / "a/b"));
    EXPECT_EQ(*readFile(root() / "disk.txt"), "disk");
}

TEST_F(MountedFiles, existAndHaveFolders) {
    EXPECT_TRUE(fileExists(root() / "a/b/c.txt"));
    EXPECT_TRUE(fileExists(root() / "disk.txt"));
    EXPECT_FALSE(fileExists(root() / "a/b"));
    EXPECT_FALSE(fileExists(root() / "a/b/c"));
    EXPECT_TRUE(folderExists(root() / "a/b"));
    EXPECT_TRUE(folderExists(root() / "a/"));
    EXPECT_TRUE(folderExists(root()));
    EXPECT_FALSE(folderExists(root() / "b"));
    EXPECT_FALSE(folderExists(root() / "a/b/c.txt"));
}

TEST_F(MountedFiles, areListedWithThoseOnTheDisk) {
    EXPECT_EQ(filesBelow(root(), ".txt"),
              (std::vector<std::string>{"a/b/c.txt", "a/bc.txt", "both.txt", "disk.txt", "top.txt"}));
    EXPECT_EQ(filesBelow(root() / "a", ".txt"), (std::vector<std::string>{"b/c.txt", "bc.txt"}));
    EXPECT_EQ(filesBelow(root() / "a/b", ".txt"), (std::vector<std::string>{"c.txt"}));
}

TEST_F(MountedFiles, obeyTheLimitOfSizes) {
    EXPECT_TRUE(readFile(root() / "a/bc.txt", 8));
    const Result<std::string> text = readFile(root() / "a/bc.txt", 7);
    ASSERT_FALSE(text);
    EXPECT_EQ(text.error().what, "the file has 8 bytes, the limit is 7");
}

TEST_F(MountedFiles, areSeenByPathInside) {
    const Result<Path> inside = pathInside(root(), "a/b/c.txt");
    ASSERT_TRUE(inside);
    EXPECT_TRUE(fileExists(*inside));
}

TEST_F(MountedFiles, haveAStampThatStays) {
    EXPECT_NE(fileStamp(root() / "top.txt"), 0u);
    EXPECT_EQ(fileStamp(root() / "top.txt"), fileStamp(root() / "top.txt"));
    EXPECT_EQ(fileStamp(root() / "none.txt"), 0u);
}

TEST_F(MountedFiles, goWhenNothingIsMounted) {
    mountFiles(root(), nullptr);
    EXPECT_FALSE(fileExists(root() / "top.txt"));
    EXPECT_FALSE(readFile(root() / "top.txt"));
    EXPECT_TRUE(fileExists(root() / "disk.txt"));
}

}  // namespace
}  // namespace plumb
