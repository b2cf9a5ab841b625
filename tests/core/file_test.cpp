#include "core/file.hpp"

#include <chrono>

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

// No user may create a folder in /sys, root included.
TEST_F(FileTest, aFolderThatCannotBeCreatedIsTheCauseThatIsReported) {
    if (!std::filesystem::exists("/sys/kernel")) GTEST_SKIP() << "Linux only";
    const Result<Done> written = writeFile("/sys/plumb/saves/1.save", "x");
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.error().what.find("No such file"), std::string::npos) << written.error().what;
    EXPECT_NE(written.error().what.find("its folder could not be created"), std::string::npos);
}

TEST_F(FileTest, aPathOf1024CharactersIsAcceptedAndALongerOneIsRefused) {
    const auto path = [](std::size_t length) {  // in folders, as names have at most 255 characters
        std::string text;
        while (text.size() + 201 < length) text += std::string(200, 'a') + "/";
        return text + std::string(length - text.size(), 'b');
    };
    EXPECT_TRUE(pathInside(root_, path(1023)).ok());
    EXPECT_TRUE(pathInside(root_, path(1024)).ok());
    const Result<Path> refused = pathInside(root_, path(1025));
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().what, "the path is longer than 1024 characters");
}

TEST_F(FileTest, controlCharactersInPathsAreRefusedAndAllOthersAccepted) {
    for (int c = 1; c < 128; ++c) {
        const std::string path = "a" + std::string(1, static_cast<char>(c)) + "b";
        const bool isAllowed = c >= 32 && c < 127 && c != ':' && c != '\\';
        EXPECT_EQ(pathInside(root_, path).ok(), isAllowed) << c;
    }
}

TEST_F(FileTest, pathsInsideARootThatDoesNotExistYetAreAccepted) {
    const Result<Path> plain = pathInside(root_ / "none", "x/y");
    ASSERT_TRUE(plain.ok());
    EXPECT_EQ(*plain, std::filesystem::weakly_canonical(root_) / "none/x/y");
    EXPECT_TRUE(pathInside(root_ / "none" / "", "x").ok()) << "with a slash at its end";
    EXPECT_FALSE(pathInside(root_ / "none" / "", "../x").ok());
}

TEST_F(FileTest, linksToFoldersBesideTheRootAreRefused) {
    std::filesystem::create_directories(root_ / "inside2" / "deep");
    std::filesystem::create_symlink("../inside2", root_ / "inside" / "beside");
    std::filesystem::create_symlink("..", root_ / "inside" / "above");
    std::filesystem::create_symlink("../inside2/deep", root_ / "inside" / "deep");
    for (const char* outside : {"beside", "beside/x", "above", "above/x", "above/inside2/x", "deep/x"})
        EXPECT_FALSE(pathInside(root_ / "inside", outside).ok()) << outside;
    EXPECT_TRUE(pathInside(root_ / "inside", "above/inside/x").ok()) << "it comes back";
}

#if defined(__linux__)
TEST_F(FileTest, aFullDiskIsAnErrorAndKeepsTheOldFile) {
    for (const std::size_t size : {std::size_t{3}, std::size_t{1} << 20}) {  // less and more than a buffer
        ASSERT_TRUE(writeFile(root_ / "file", "old").ok());
        std::filesystem::create_symlink("/dev/full", root_ / "file.tmp~");  // each write to it fails
        const Result<Done> done = writeFile(root_ / "file", std::string(size, 'x'));
        ASSERT_FALSE(done.ok());
        EXPECT_EQ(done.error().remedy, "free some space; the old file is untouched");
        EXPECT_EQ(*readFile(root_ / "file"), "old");
        EXPECT_EQ(filesBelow(root_, ""), std::vector<std::string>{"file"});
    }
}
#endif

TEST_F(FileTest, filesAreListedByTheirEndingInOrder) {
    for (const char* name : {"b.png", "a.png", "inside/c.png", "d.jpg", "png", ".png"})
        ASSERT_TRUE(writeFile(root_ / name, "x").ok());
    std::filesystem::create_directories(root_ / "folder.png");
    std::filesystem::create_directory_symlink("inside", root_ / "link");
    EXPECT_EQ(filesBelow(root_, ".png"),
              (std::vector<std::string>{".png", "a.png", "b.png", "inside/c.png"}));
    EXPECT_EQ(filesBelow(root_, "none"), std::vector<std::string>{});
    EXPECT_EQ(filesBelow(root_ / "none", ""), std::vector<std::string>{});
}

TEST_F(FileTest, theStampChangesWithTheSizeAndTheTime) {
    const Path path = root_ / "file";
    EXPECT_EQ(fileStamp(path), 0u) << "there is none";
    ASSERT_TRUE(writeFile(path, "one").ok());
    const auto time = std::filesystem::last_write_time(path);
    const std::uint64_t stamp = fileStamp(path);
    EXPECT_NE(stamp, 0u);
    EXPECT_EQ(fileStamp(path), stamp);
    std::filesystem::last_write_time(path, time + std::chrono::seconds{1});
    EXPECT_NE(fileStamp(path), stamp);
    ASSERT_TRUE(writeFile(path, "four").ok());
    std::filesystem::last_write_time(path, time);
    EXPECT_NE(fileStamp(path), stamp);
    ASSERT_TRUE(writeFile(path, "two").ok());
    std::filesystem::last_write_time(path, time);
    EXPECT_EQ(fileStamp(path), stamp);
}

}  // namespace
}  // namespace plumb
