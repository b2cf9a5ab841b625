#include "core/file_lock.hpp"

#include <cstdlib>
#include <unistd.h>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

class FileLocks : public ::testing::Test {
protected:
    [[nodiscard]] bool isFree() const { return FileLock::take(path_).has_value(); }

    const test::TemporaryFolder folder_;
    const Path path_ = folder_.path / "new folder" / "lock";
};

TEST_F(FileLocks, oneHolderAtATime) {
    {
        const std::optional<FileLock> lock = FileLock::take(path_);
        ASSERT_TRUE(lock.has_value());
        EXPECT_TRUE(std::filesystem::is_regular_file(path_)) << "with its folder";
        EXPECT_FALSE(isFree());
        EXPECT_FALSE(isFree()) << "a refused lock does not release the other one";
        EXPECT_TRUE(FileLock::take(folder_.path / "other").has_value());
    }
    EXPECT_TRUE(isFree());
}

TEST_F(FileLocks, aMovedLockIsReleasedOnceByItsLastOwner) {
    std::optional<FileLock> lock = FileLock::take(path_);
    ASSERT_TRUE(lock.has_value());
    {
        const FileLock moved{std::move(*lock)};
        lock.reset();
        EXPECT_FALSE(isFree());
    }
    EXPECT_TRUE(isFree());
}

TEST_F(FileLocks, aFileThatCannotBeCreatedIsNotLocked) {
    EXPECT_FALSE(FileLock::take(folder_.path).has_value()) << "a folder";
    ASSERT_TRUE(writeFile(folder_.path / "file", "x").ok());
    EXPECT_FALSE(FileLock::take(folder_.path / "file" / "lock").has_value());
}

/// Exits with 0 if a lock works whose file has the descriptor 0.
[[noreturn]] void lockWithClosedInput(const Path& path) {
    ::close(STDIN_FILENO);
    std::optional<FileLock> lock = FileLock::take(path);
    if (!lock) std::exit(1);
    if (FileLock::take(path)) std::exit(2);
    lock.reset();
    std::exit(FileLock::take(path) ? 0 : 3);
}

TEST_F(FileLocks, workInAProgramWithoutStandardInput) {
    EXPECT_EXIT(lockWithClosedInput(path_), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace plumb
