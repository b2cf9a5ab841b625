#include "core/file.hpp"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

class FileTest : public ::testing::Test {
protected:
    FileTest() { std::filesystem::create_directories(root_ / "inside"); }

    const test::TemporaryFolder folder_;
    const Path root_ = folder_.path;
};

TEST_F(FileTest, writtenFilesReadBackAndNoTemporaryFileRemains) {
    const std::string bytes{"a\0b\n", 4};
    ASSERT_TRUE(writeFile(root_ / "new" / "file.bin", bytes).ok());

    EXPECT_EQ(*readFile(root_ / "new" / "file.bin"), bytes);
    EXPECT_EQ(filesBelow(root_, ""), std::vector<std::string>{"new/file.bin"});
}

TEST_F(FileTest, missingFilesFoldersAndTooLargeFilesAreErrorsWithARemedy) {
    ASSERT_TRUE(writeFile(root_ / "ten", "0123456789").ok());

    for (const auto& result :
         {readFile(root_ / "none"), readFile(root_ / "inside"), readFile(root_ / "ten", 9)}) {
        ASSERT_FALSE(result.ok());
        EXPECT_FALSE(result.error().where.empty());
        EXPECT_FALSE(result.error().what.empty());
        EXPECT_FALSE(result.error().remedy.empty());
    }
    EXPECT_TRUE(readFile(root_ / "ten", 10).ok());
}

TEST_F(FileTest, pathsOutsideTheProjectAreRejected) {
    std::filesystem::create_symlink("/etc", root_ / "link");
    std::filesystem::create_symlink("inside", root_ / "good");
    for (const char* outside :
         {"../x", "a/../../x", "/etc/passwd", "", "C:/x", "a\\b", "\\\\host\\share", "link/passwd", "link",
          "a\nb", "..", "inside/..", "\x7f", "\xff\xfe", "//x"}) {
        EXPECT_FALSE(pathInside(root_, outside).ok()) << outside;
    }
    for (const char* inside : {"x", "inside/x", "inside/./x", "good/x", "with space/é.png", "...", "a..b"}) {
        EXPECT_TRUE(pathInside(root_, inside).ok()) << inside;
    }
}

TEST_F(FileTest, anUnwritablePathIsAnErrorAndLeavesNoFile) {
    ASSERT_TRUE(writeFile(root_ / "file", "old").ok());

    EXPECT_FALSE(writeFile(root_ / "file" / "below", "new").ok());
    EXPECT_FALSE(writeFile(root_ / "inside", "new").ok());

    EXPECT_EQ(*readFile(root_ / "file"), "old");
    EXPECT_EQ(filesBelow(root_, ""), std::vector<std::string>{"file"});
}

}  // namespace
}  // namespace plumb
