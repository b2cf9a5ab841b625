// The files of an import are replaced all together or not at all, even if the program is killed.

#include "scene/files/import_commit.hpp"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

#ifdef __unix__
#include <csignal>
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace plumb {
namespace {

struct ImportCommit : testing::Test {
    test::TemporaryFolder folder{test::memoryFolder()};
    const Path root = folder.path;

    static std::vector<ImportedFile> filesOf(const std::string& content, int count = 12) {
        std::vector<ImportedFile> files;
        for (int i = 0; i < count; ++i)
            files.push_back({"assets/level/" + std::to_string(i) + ".txt", content});
        return files;
    }
    /// Returns the common content of all files, "none" if there are no files, "mixed" if they differ.
    [[nodiscard]] std::string content() const {
        std::string all = "none";
        const std::vector<std::string> files = filesBelow(root / "assets", "");
        for (const std::string& file : files) {
            const std::string own = *readFile(root / "assets" / file);
            all = all == "none" || all == own ? own : "mixed";
        }
        return files.empty() || files.size() == filesOf("").size() ? all : "some files are missing";
    }
};

TEST_F(ImportCommit, allFilesAreWrittenAndNoTemporaryOnesRemain) {
    ASSERT_TRUE(commitImport(root, filesOf("one")).ok());
    EXPECT_EQ(content(), "one");
    ASSERT_TRUE(commitImport(root, filesOf("two")).ok());
    EXPECT_EQ(content(), "two");
    EXPECT_FALSE(std::filesystem::exists(root / ".plumb"));
}

TEST_F(ImportCommit, aFileThatCannotBeReplacedRevertsTheImport) {
    ASSERT_TRUE(commitImport(root, filesOf("one")).ok());
    for (const char* wrong : {"assets/level", "../outside.txt", "assets/level/3.txt/below.txt"}) {
        SCOPED_TRACE(wrong);
        std::vector<ImportedFile> files = filesOf("two");
        files.push_back({wrong, "two"});
        const Result<Done> done = commitImport(root, files);
        ASSERT_FALSE(done.ok());
        EXPECT_FALSE(done.error().remedy.empty());
        EXPECT_EQ(content(), "one");
        EXPECT_FALSE(std::filesystem::exists(root / ".plumb"));
    }
}

#ifdef __unix__
/// A child process imports in a loop and is killed at a different moment in each round.
TEST_F(ImportCommit, aKilledImportIsCompletedOrReverted) {
    ASSERT_TRUE(commitImport(root, filesOf("0")).ok());
    int finished = 0;
    for (int round = 0; round < 40; ++round) {
        const pid_t child = ::fork();
        if (child == 0) {
            for (int i = 0; i < 1000; ++i) static_cast<void>(commitImport(root, filesOf(std::to_string(i))));
            ::_exit(0);
        }
        ASSERT_GT(child, 0);
        ::usleep(static_cast<useconds_t>(2000 + round * 137));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        finished += content() == "mixed" ? 1 : 0;
        finishImport(root);
        ASSERT_NE(content(), "mixed") << round;
        ASSERT_NE(content(), "some files are missing") << round;
        ASSERT_TRUE(commitImport(root, filesOf("after")).ok());
        ASSERT_EQ(content(), "after");
        EXPECT_FALSE(std::filesystem::exists(root / ".plumb"));
        for (const std::string& file : filesBelow(root, ""))
            EXPECT_EQ(file.find('~'), std::string::npos) << file;
    }
    RecordProperty("finished", std::to_string(finished));
}
#endif

}  // namespace
}  // namespace plumb
