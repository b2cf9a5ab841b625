#include "core/crash.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <fcntl.h>
#include <pthread.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#if __has_include(<execinfo.h>)
#include <dlfcn.h>
#include <execinfo.h>
#define PLUMB_BACK_TRACE
#endif
#if defined(__linux__)
#include <link.h>
#endif

#include "core/crash_report.hpp"

namespace plumb {

constinit thread_local std::string_view Running::current;

namespace {

constexpr int kHang = SIGUSR2;  // of the watchdog, see reportHang()

struct Signal {
    int number;
    std::string_view text;
};
constexpr std::array kSignals{
    Signal{SIGSEGV, "SIGSEGV, a wrong access to memory"},
    Signal{SIGBUS, "SIGBUS, a wrong access to memory"},
    Signal{SIGFPE, "SIGFPE, e.g. a division of integers by zero"},
    Signal{SIGILL, "SIGILL, an invalid instruction"},
    Signal{SIGABRT, "SIGABRT, a failed assertion, an exception that is not caught, or damaged memory"},
    Signal{kHang, "a tick takes more than 5 s"}};

constexpr int kFrames = 64;                   // of a back trace
constexpr std::size_t kStack = 131072;        // bytes: the report of a stack overflow needs another stack
constexpr std::uintptr_t kNullBytes = 65536;  // a wrong access to an address below is one by a null pointer
constexpr std::uintptr_t kOverflow = 1u
                                     << 20u;  // bytes: largest distance of an overflow from the stack's end

pthread_t reportingThread{};  // the one that called reportCrashes()
std::uintptr_t stackEnd = 0;  // its lowest address; 0: unknown
long timeZone = 0;            // s to add to UTC
std::atomic<int> reporting{0};
pthread_t reporter{};        // the thread that writes a report, if reporting != 0
void* trampoline = nullptr;  // return address of report(): the frame above is that of the crash

// What follows runs in a signal handler: it calls only functions that are safe there, but for backtrace() and
// dladdr(), which may wait for a lock of the loader while another thread loads a library.

#if defined(PLUMB_BACK_TRACE)
/// Prints the file without its folders, which may be those of a user, the function, and the place in the
/// file.
void printFrame(CrashOutput& out, void* address) {
    Dl_info info{};
    if (dladdr(address, &info) == 0 || info.dli_fname == nullptr) {
        out.text("an unknown file\n");
        return;
    }
    const std::string_view path = info.dli_fname;
    const auto place = reinterpret_cast<std::uintptr_t>(address);
    out.text(path.substr(path.rfind('/') + 1)).text(" +");
    out.hex(place - reinterpret_cast<std::uintptr_t>(info.dli_fbase));
    if (info.dli_sname != nullptr) {
        out.text(" ").text(info.dli_sname).text(" +");
        out.number(place - reinterpret_cast<std::uintptr_t>(info.dli_saddr));
    }
    out.text("\n");
}
#endif

void printBackTrace([[maybe_unused]] CrashOutput& out, [[maybe_unused]] int file,
                    [[maybe_unused]] bool isTerminal) {
#if defined(PLUMB_BACK_TRACE)
    std::array<void*, kFrames> frames{};
    const int count = backtrace(frames.data(), kFrames);
    out.text("back trace, innermost function first (c++filt makes the names readable):\n");
    int first = 0;
    while (first < count && frames[static_cast<std::size_t>(first)] != trampoline) ++first;
    first = first < count ? first + 1 : 0;
    if (isTerminal) return backtrace_symbols_fd(frames.data() + first, count - first, file);
    for (int i = first; i < count; ++i) printFrame(out, frames[static_cast<std::size_t>(i)]);
#endif
}

std::string_view reasonOf(int number, const siginfo_t* info) {
    if (!crash::reason().empty()) return crash::reason();
    if (info == nullptr) return {};
    if (info->si_code == SI_USER) return "the signal was sent by a process";
    if (number != SIGSEGV || info->si_code <= 0) return {};
    const auto address = reinterpret_cast<std::uintptr_t>(info->si_addr);
    if (address < kNullBytes) return "a null pointer";
    if (stackEnd != 0 && address < stackEnd + kOverflow && address > stackEnd - kOverflow)
        return "the stack is full, as by a recursion without end";
    return {};
}

/// Lets one thread report. One that crashes meanwhile waits: the program ends with the report. A crash of the
/// report itself ends the program at once.
bool beginReport() {
    int none = 0;
    if (reporting.compare_exchange_strong(none, 1)) {
        reporter = pthread_self();
        return true;
    }
    if (pthread_equal(reporter, pthread_self()) != 0) _exit(128 + SIGABRT);
    constexpr int kLongest = 10;  // s
    for (int i = 0; i < kLongest; ++i) sleep(1);
    return false;
}

void report(int number, siginfo_t* info, void*) {
    const int error = errno;
    if (beginReport()) {
        trampoline = __builtin_return_address(0);
        const auto* signal = std::find_if(kSignals.begin(), kSignals.end(),
                                          [&](const Signal& known) { return known.number == number; });
        crash::write({signal->text, reasonOf(number, info), Running::current, number == kHang},
                     printBackTrace);
    }
    if (number == kHang) {
        if (crash::endsAtHang()) _exit(128 + SIGABRT);
        reporting = 0;
        errno = error;
        return;
    }
    std::signal(number, SIG_DFL);
    raise(number);  // follows when this function returns: the signal is blocked
}

void handle(int number, const sigset_t& all) {
    struct sigaction known {};
    if (sigaction(number, nullptr, &known) != 0 || known.sa_handler != SIG_DFL) return;
    struct sigaction action {};
    action.sa_sigaction = report;
    action.sa_mask = all;
    action.sa_flags = static_cast<int>(SA_ONSTACK | SA_SIGINFO | SA_RESTART);
    sigaction(number, &action, nullptr);
}

/// Where the stack of the first thread ends: it begins a little above this function's frame.
std::uintptr_t endOfStack() {
    rlimit limit{};
    if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return 0;
    return reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0)) -
           static_cast<std::uintptr_t>(limit.rlim_cur);
}

#if defined(__linux__)
/// Finds the note of the program itself, the first object, in which the linker stores the build's id.
int findBuildId(dl_phdr_info* object, std::size_t, void* found) {
    constexpr std::size_t kWord = 4;  // bytes: names and contents of notes are padded to words
    for (int i = 0; i < object->dlpi_phnum; ++i) {
        const auto& header = object->dlpi_phdr[i];
        if (header.p_type != PT_NOTE) continue;
        const auto* at = reinterpret_cast<const unsigned char*>(object->dlpi_addr + header.p_vaddr);
        const unsigned char* end = at + header.p_memsz;
        while (at + sizeof(ElfW(Nhdr)) <= end) {
            const auto* note = reinterpret_cast<const ElfW(Nhdr)*>(at);
            const auto padded = [](std::size_t bytes) { return (bytes + kWord - 1) / kWord * kWord; };
            const unsigned char* content = at + sizeof *note + padded(note->n_namesz);
            if (note->n_type == NT_GNU_BUILD_ID && content + note->n_descsz <= end) {
                for (std::size_t k = 0; k < note->n_descsz; ++k) {
                    *static_cast<std::string*>(found) += "0123456789abcdef"[content[k] >> 4];
                    *static_cast<std::string*>(found) += "0123456789abcdef"[content[k] & 15];
                }
                return 1;
            }
            at = content + padded(note->n_descsz);
        }
    }
    return 1;  // no other object
}
#endif

}  // namespace

namespace crash {

int createFile(const Path::value_type* path) {
    return ::open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
}
bool exists(const Path::value_type* path) { return ::access(path, F_OK) == 0; }
void closeFile(int file) { ::close(file); }
bool renameFile(const Path::value_type* from, const Path::value_type* to) { return ::rename(from, to) == 0; }
void removeFile(const Path::value_type* path) { ::unlink(path); }

std::int64_t writeSome(int file, const char* bytes, std::size_t count) {
    ssize_t written = -1;
    do {
        written = ::write(file, bytes, count);
    } while (written < 0 && errno == EINTR);
    return written;
}

/// Without localtime(), which may wait for a lock.
/// Source: H. Hinnant, "chrono-Compatible Low-Level Date Algorithms", civil_from_days
Date now() {
    constexpr std::int64_t kDay = 86400;  // s
    const auto seconds = static_cast<std::int64_t>(std::time(nullptr)) + timeZone;
    const std::int64_t days = seconds / kDay + 719468;  // since March 1st of year 0
    const std::int64_t inDay = seconds % kDay;
    const std::int64_t era = days / 146097;
    const std::int64_t ofEra = days % 146097;
    const std::int64_t year = (ofEra - ofEra / 1460 + ofEra / 36524 - ofEra / 146096) / 365;
    const std::int64_t ofYear = ofEra - (365 * year + year / 4 - year / 100);
    const std::int64_t month = (5 * ofYear + 2) / 153;  // from March
    Date date;
    date.day = static_cast<int>(ofYear - (153 * month + 2) / 5 + 1);
    date.month = static_cast<int>(month < 10 ? month + 3 : month - 9);
    date.year = static_cast<int>(year + era * 400 + (month < 10 ? 0 : 1));
    date.hour = static_cast<int>(inDay / 3600);
    date.minute = static_cast<int>(inDay / 60 % 60);
    date.second = static_cast<int>(inDay % 60);
    return date;
}

}  // namespace crash

void reportCrashes(std::string_view remedy) {
    crash::setRemedy(remedy);
    crash::reportExceptions();
    reportingThread = pthread_self();
    stackEnd = endOfStack();
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    if (localtime_r(&now, &local) != nullptr) timeZone = local.tm_gmtoff;
#if defined(PLUMB_BACK_TRACE)
    std::array<void*, 1> frame{};
    backtrace(frame.data(), 1);  // the first call allocates memory
#endif
    static std::array<char, kStack> memory;
    stack_t stack{};
    stack.ss_sp = memory.data();
    stack.ss_size = memory.size();
    if (sigaltstack(&stack, nullptr) != 0) return;
    sigset_t all{};
    sigemptyset(&all);
    for (const Signal& signal : kSignals) sigaddset(&all, signal.number);
    for (const Signal& signal : kSignals) handle(signal.number, all);
}

void reportHang() {
    struct sigaction known {};
    if (sigaction(kHang, nullptr, &known) != 0 || known.sa_sigaction != report) return;
    pthread_kill(reportingThread, kHang);
}

bool canReportCrashes() { return true; }

std::string buildId() {
    std::string id;
#if defined(__linux__)
    dl_iterate_phdr(findBuildId, &id);
#endif
    return id;
}

}  // namespace plumb
