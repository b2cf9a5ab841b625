#include "core/crash.hpp"

#include <array>
#include <atomic>
#include <csignal>
#include <cwchar>
#include <fcntl.h>
#include <io.h>

#define WIN32_LEAN_AND_MEAN
#if !defined(NOMINMAX)
#define NOMINMAX
#endif
#include <windows.h>

#include "core/crash_report.hpp"

namespace plumb {

constinit thread_local std::string_view Running::current;

namespace {

struct Exception {
    DWORD code;
    std::string_view text;
};
constexpr std::array kExceptions{
    Exception{EXCEPTION_ACCESS_VIOLATION, "a wrong access to memory"},
    Exception{EXCEPTION_IN_PAGE_ERROR, "a wrong access to memory"},
    Exception{EXCEPTION_STACK_OVERFLOW, "the stack is full, as by a recursion without end"},
    Exception{EXCEPTION_INT_DIVIDE_BY_ZERO, "a division of integers by zero"},
    Exception{EXCEPTION_ILLEGAL_INSTRUCTION, "an invalid instruction"}};

constexpr int kFrames = 62;              // of a back trace: the limit of some versions of Windows
constexpr ULONG kStack = 16384;          // bytes of the stack that remain for the handler of an overflow
constexpr SIZE_T kReportStack = 131072;  // bytes of the stack of the report, which has a thread of its own
constexpr DWORD kLongest = 10000;        // ms in which a report is written
constexpr DWORD kLongestTrace = 2000;    // ms in which a back trace is read
constexpr UINT kExitCode = 3;            // that of abort()
constexpr ULONG_PTR kNullBytes = 65536;  // a wrong access to an address below is one by a null pointer

std::atomic<DWORD> reporter{0};                  // thread that crashed, or that reports a hang; 0: none
const std::string_view* runningThere = nullptr;  // what it runs

// A thread of its own writes the report, because the one that crashed may have no stack left. It asks that
// one for the back trace last, as reading it may fail.
Crash crashed;
HANDLE begins = nullptr;  // event: `crashed` is valid
HANDLE wanted = nullptr;  // event: the back trace is to be read
HANDLE isRead = nullptr;  // event: the back trace was read
std::array<void*, kFrames> frames{};
int frameCount = -1;  // -1: not read yet

void printFrame(CrashOutput& out, void* frame) {
    constexpr DWORD kOfAddress =
        GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT;
    HMODULE module = nullptr;
    std::array<char, MAX_PATH> path{};
    if (GetModuleHandleExA(kOfAddress, static_cast<const char*>(frame), &module) == 0 || module == nullptr)
        return;
    const DWORD size = GetModuleFileNameA(module, path.data(), MAX_PATH);
    const std::string_view name{path.data(), size};
    out.text(name.substr(name.find_last_of("\\/") + 1)).text(" +");
    out.hex(reinterpret_cast<ULONG_PTR>(frame) - reinterpret_cast<ULONG_PTR>(module)).text("\n");
}

void printBackTrace(CrashOutput& out, int, bool) {
    if (frameCount < 0) {
        SetEvent(wanted);
        if (WaitForSingleObject(isRead, kLongestTrace) != WAIT_OBJECT_0) return;
    }
    out.text("back trace, innermost function first:\n");
    for (int i = 0; i < frameCount; ++i) printFrame(out, frames[static_cast<std::size_t>(i)]);
}

DWORD WINAPI writeReport(void*) {
    WaitForSingleObject(begins, INFINITE);
    crash::write(crashed, printBackTrace);
    TerminateProcess(GetCurrentProcess(), kExitCode);  // without the dialog of the system
    return 0;
}

/// Lets one thread report; another that crashes meanwhile waits for the end of the program. A crash of the
/// report itself ends the program at once.
void beginReport() {
    DWORD none = 0;
    const DWORD self = GetCurrentThreadId();
    if (reporter.compare_exchange_strong(none, self)) return;
    if (none == self) TerminateProcess(GetCurrentProcess(), kExitCode);
    Sleep(INFINITE);
}

/// Does not return.
void report(const Crash& crash) {
    beginReport();
    crashed = crash;
    SetEvent(begins);
    if (WaitForSingleObject(wanted, kLongest) == WAIT_OBJECT_0) {
        frameCount = CaptureStackBackTrace(0, kFrames, frames.data(), nullptr);
        SetEvent(isRead);
        Sleep(kLongest);
    }
    TerminateProcess(GetCurrentProcess(), kExitCode);
}

LONG WINAPI reportException(EXCEPTION_POINTERS* pointers) {
    const EXCEPTION_RECORD& record = *pointers->ExceptionRecord;
    Crash crash{"an exception of the system", crash::reason(), Running::current, false};
    for (const Exception& known : kExceptions) {
        if (known.code == record.ExceptionCode) crash.what = known.text;
    }
    if (record.ExceptionCode == EXCEPTION_ACCESS_VIOLATION && record.NumberParameters > 1 &&
        record.ExceptionInformation[1] < kNullBytes)
        crash.reason = "a null pointer";
    report(crash);
    return EXCEPTION_EXECUTE_HANDLER;
}

void reportAbort(int) {
    report({"abort(): a failed assertion, an exception that is not caught, or damaged memory",
            crash::reason(), Running::current, false});
}

}  // namespace

namespace crash {

int createFile(const Path::value_type* path) {
    // Shared for deletion, so that it can be renamed while it is open.
    const HANDLE file = CreateFileW(path, GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_DELETE, nullptr,
                                    CREATE_NEW, FILE_ATTRIBUTE_NORMAL, nullptr);
    if (file == INVALID_HANDLE_VALUE) return -1;
    return ::_open_osfhandle(reinterpret_cast<intptr_t>(file), _O_BINARY);
}
bool exists(const Path::value_type* path) { return GetFileAttributesW(path) != INVALID_FILE_ATTRIBUTES; }
void closeFile(int file) { ::_close(file); }
bool renameFile(const Path::value_type* from, const Path::value_type* to) {
    return MoveFileExW(from, to, 0) != 0;
}
void removeFile(const Path::value_type* path) { DeleteFileW(path); }
std::int64_t writeSome(int file, const char* bytes, std::size_t count) {
    return ::_write(file, bytes, static_cast<unsigned>(count));
}

Date now() {
    SYSTEMTIME time{};
    GetLocalTime(&time);
    return {time.wYear, time.wMonth, time.wDay, time.wHour, time.wMinute, time.wSecond};
}

}  // namespace crash

void reportCrashes(std::string_view remedy) {
    crash::setRemedy(remedy);
    crash::reportExceptions();
    ULONG stack = kStack;
    SetThreadStackGuarantee(&stack);
    runningThere = &Running::current;
    if (begins == nullptr) {
        begins = CreateEventW(nullptr, FALSE, FALSE, nullptr);
        wanted = CreateEventW(nullptr, FALSE, FALSE, nullptr);
        isRead = CreateEventW(nullptr, FALSE, FALSE, nullptr);
        CloseHandle(CreateThread(nullptr, kReportStack, writeReport, nullptr, 0, nullptr));
    }
    SetUnhandledExceptionFilter(reportException);
    std::signal(SIGABRT, reportAbort);
}

/// On the calling thread: the one that hangs goes on.
void reportHang() {
    DWORD none = 0;
    if (runningThere == nullptr || !reporter.compare_exchange_strong(none, GetCurrentThreadId())) return;
    crash::write({"a tick takes more than 5 s", {}, *runningThere, true}, [](CrashOutput&, int, bool) {});
    if (crash::endsAtHang()) TerminateProcess(GetCurrentProcess(), kExitCode);
    reporter = 0;
}

bool canReportCrashes() { return true; }

std::string buildId() {
    // The time and the size in the header of the program's file.
    const auto* start = reinterpret_cast<const unsigned char*>(GetModuleHandleW(nullptr));
    const auto* dos = reinterpret_cast<const IMAGE_DOS_HEADER*>(start);
    const auto* header = reinterpret_cast<const IMAGE_NT_HEADERS*>(start + dos->e_lfanew);
    std::string id;
    for (DWORD number : {header->FileHeader.TimeDateStamp, header->OptionalHeader.SizeOfImage,
                         header->OptionalHeader.CheckSum}) {
        for (int shift = 28; shift >= 0; shift -= 4) id += "0123456789abcdef"[number >> shift & 15];
    }
    return id;
}

}  // namespace plumb
