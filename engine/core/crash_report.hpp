#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/file.hpp"

namespace plumb {

/// What is known about a crash.
struct Crash {
    std::string_view what;     ///< e.g. "SIGSEGV, a wrong access to memory"
    std::string_view reason;   ///< the failed assertion or the exception; empty: unknown
    std::string_view running;  ///< see Running; empty: none
    bool isHang = false;       ///< the program still runs: a tick takes too long
};

/// Writes to an open file. Safe in a signal handler: allocates nothing and calls only what is safe there.
class CrashOutput {
public:
    explicit CrashOutput(int file) : file_{file} {}

    CrashOutput& text(std::string_view text);
    CrashOutput& number(std::uint64_t number);
    /// 16 digits
    CrashOutput& hex(std::uint64_t number);
    [[nodiscard]] bool failed() const { return failed_; }

private:
    int file_;
    bool failed_ = false;
};

/// The file that a crash leaves, and what the terminal says about it. Its functions run in a signal handler,
/// perhaps on another thread than the game and in the middle of any function: they allocate nothing, wait for
/// nothing, and read only what is complete at any time.
class CrashReport {
public:
    virtual ~CrashReport() = default;
    /// Writes the file but for the back trace, which follows.
    virtual void writeFile(CrashOutput& file, const Crash& crash) const = 0;
    /// Adds lines to the report on the terminal.
    virtual void explain(CrashOutput& terminal, const Crash& crash) const = 0;
    /// True if a tick that takes too long ends the program. Otherwise the program goes on after the report.
    [[nodiscard]] virtual bool endsAtHang() const { return false; }
};

/// Makes a crash write `crash-YYYYMMDD-HHMMSS.replay`, in local time, if the program calls reportCrashes().
/// @param report  null: none; must stay valid until the next call
/// @param folder  must exist; empty: the report has no file
void setCrashReport(const CrashReport* report, const Path& folder);

/// Adds the cause to the report of the crash that follows, e.g. the sentence of a failed assertion. The first
/// 511 bytes are kept.
void setCrashReason(std::string_view reason);

/// Makes the thread that called reportCrashes() report that it hangs. The program goes on, see CrashReport.
void reportHang();

/// False where a program cannot leave a file when it crashes.
[[nodiscard]] bool canReportCrashes();

/// Identifies the build of this program; empty if the system does not know it.
[[nodiscard]] std::string buildId();

// ---- for the folders of the systems

namespace crash {

/// Prints the report of a crash to the terminal and writes its file.
/// @param trace  writes a back trace; `isTerminal`: with addresses and full names of files
void write(const Crash& crash, void (*trace)(CrashOutput& out, int file, bool isTerminal));
/// Lets the program end with a report at an exception that is not caught.
void reportExceptions();
[[nodiscard]] std::string_view reason();
[[nodiscard]] bool endsAtHang();
/// The lines that reportCrashes() adds.
void setRemedy(std::string_view remedy);

// What follows is implemented for each system and safe in a signal handler.

/// Creates a file. @return -1 if there is one, or without permission
int createFile(const Path::value_type* path);
bool exists(const Path::value_type* path);
void closeFile(int file);
bool renameFile(const Path::value_type* from, const Path::value_type* to);
void removeFile(const Path::value_type* path);
/// Writes a part of the bytes. @return their number; 0 or less: failed
std::int64_t writeSome(int file, const char* bytes, std::size_t count);
/// The local time.
struct Date {
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0;
};
Date now();

}  // namespace crash
}  // namespace plumb
