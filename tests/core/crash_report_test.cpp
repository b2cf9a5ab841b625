#ifndef _WIN32

#include "core/crash_report.hpp"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <unistd.h>

#include <gtest/gtest.h>

#include "core/assert.hpp"
#include "core/crash.hpp"
#include "core/text.hpp"
#include "tests/support/crashes.hpp"
#include "tests/support/file_size_limit.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

using test::writeToNull;

/// Writes what it knows; may crash itself.
struct TestReport final : CrashReport {
    bool crashes = false;
    int lines = 0;  ///< more of them

    void writeFile(CrashOutput& file, const Crash& crash) const override {
        file.text("what ").text(crash.what).text("\nwhy ").text(crash.reason);
        file.text("\nrunning ").text(crash.running).text("\nnumber ").number(0).text(" ");
        file.number(18'446'744'073'709'551'615u).text(" ").hex(0xab).text("\n");
        for (int i = 0; i < lines; ++i) file.text("another line of the report\n");
        if (crashes) writeToNull();
    }
    void explain(CrashOutput& terminal, const Crash&) const override { terminal.text("explained\n"); }
};

class CrashReportFile : public test::CrashTest {
protected:
    /// To be called in the child process.
    void prepare() {
        reportCrashes("");
        setCrashReport(&report, folder_.path);
    }
    [[nodiscard]] std::vector<std::string> files() const { return filesBelow(folder_.path, ""); }
    [[nodiscard]] std::string text() const {
        return files().empty() ? std::string{} : *readFile(folder_.path / files().front());
    }

    TestReport report;

private:
    test::TemporaryFolder folder_;
};

TEST_F(CrashReportFile, hasTheCauseThePlaceAndABackTraceWithoutFolders) {
    EXPECT_EXIT(
        {
            prepare();
            const Running running{"MoveSystem"};
            writeToNull();
        },
        testing::KilledBySignal(SIGSEGV),
        "a null pointer\nrunning: MoveSystem\n\nthe report is in .*explained");
    ASSERT_EQ(files().size(), 1u);
    EXPECT_TRUE(startsWith(files().front(), "crash-20")) << files().front();
    EXPECT_TRUE(endsWith(files().front(), ".replay"));
    EXPECT_EQ(files().front().size(), std::string_view{"crash-YYYYMMDD-HHMMSS.replay"}.size());
    EXPECT_TRUE(startsWith(text(),
                           "what SIGSEGV, a wrong access to memory\nwhy a null pointer\nrunning MoveSystem\n"
                           "number 0 18446744073709551615 00000000000000ab\n"
                           "back trace"))
        << text();
#if defined(__GLIBC__)
    EXPECT_NE(text().find("\ncore_tests +"), std::string::npos) << text();
    EXPECT_EQ(text().find('/'), std::string::npos) << text();
#endif
}

TEST_F(CrashReportFile, ofAnExceptionOrAnAssertionHasItsText) {
    EXPECT_EXIT(
        {
            prepare();
            std::thread{[] { throw std::runtime_error{"no such\nlevel"}; }}.join();
        },
        testing::KilledBySignal(SIGABRT), "SIGABRT.*: no such level\n");
    EXPECT_NE(text().find("why no such level\n"), std::string::npos) << text();
    EXPECT_EXIT(
        {
            prepare();
            failAssertion("a body has a mass", "bodies.cpp", 1);
        },
        testing::KilledBySignal(SIGABRT), "bodies.cpp:1: a body has a mass.*: a body has a mass\n");
}

TEST_F(CrashReportFile, ofAnErrorOfTheFileSystemHasNoFolders) {
    EXPECT_EXIT(
        {
            prepare();
            std::thread{[] {
                throw std::filesystem::filesystem_error("cannot copy", "/home/me/level.txt", "/root/copy.txt",
                                                        make_error_code(std::errc::not_a_directory));
            }}.join();
        },
        testing::KilledBySignal(SIGABRT), "Not a directory: level.txt: copy.txt\n");
    EXPECT_NE(text().find("why Not a directory: level.txt: copy.txt\n"), std::string::npos) << text();
}

TEST_F(CrashReportFile, ofCrashesInTheSameSecondHaveTheirOwnNames) {
    for (int i = 0; i < 3; ++i) {
        EXPECT_EXIT((prepare(), std::abort()), testing::KilledBySignal(SIGABRT), "");
    }
    EXPECT_EQ(files().size(), 3u);
}

TEST_F(CrashReportFile, thatCrashesItselfEndsTheProgramAtOnce) {
    report.crashes = true;
    EXPECT_EXIT((alarm(20), prepare(), std::abort()), testing::KilledBySignal(SIGSEGV), "crashed: SIGABRT");
    ASSERT_EQ(files().size(), 1u);
    EXPECT_TRUE(endsWith(files().front(), ".part")) << "not complete";
}

TEST_F(CrashReportFile, ofThreadsThatCrashTogetherIsOne) {
    EXPECT_EXIT(
        {
            prepare();
            std::thread other{writeToNull};
            writeToNull();
            other.join();
        },
        testing::KilledBySignal(SIGSEGV), "explained");
    EXPECT_EQ(files().size(), 1u);
}

TEST_F(CrashReportFile, onAFullDiskIsRemovedAndTheTerminalSaysSo) {
    report.lines = 4000;
    EXPECT_EXIT(
        {
            prepare();
            const test::FileSizeLimit limit{60'000};  // more than the output of the test
            std::abort();
        },
        testing::KilledBySignal(SIGABRT), "could not be written: the disk is full");
    EXPECT_TRUE(files().empty());
}

TEST_F(CrashReportFile, ofAHangLetsTheProgramGoOn) {
    EXPECT_EXIT(
        {
            prepare();
            const Running running{"LoadSystem"};
            std::thread{reportHang}.join();
            std::_Exit(7);
        },
        testing::ExitedWithCode(7), "hangs: a tick takes more than 5 s\nrunning: LoadSystem");
    EXPECT_EQ(files().size(), 1u);
    EXPECT_NE(text().find("running LoadSystem"), std::string::npos) << text();
}

TEST_F(CrashReportFile, ofAHangWithoutReportCrashesDoesNothing) {
    EXPECT_EXIT((reportHang(), std::_Exit(7)), testing::ExitedWithCode(7), "^$");
}

#if defined(__GLIBC__)
TEST(BuildId, isTheHashThatTheLinkerStored) {
    EXPECT_GE(buildId().size(), 16u);
    EXPECT_EQ(buildId().find_first_not_of("0123456789abcdef"), std::string::npos);
}
#endif

}  // namespace
}  // namespace plumb

#endif
