#include "core/crash.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <unistd.h>
#if __has_include(<execinfo.h>)
#include <execinfo.h>
#define PLUMB_BACK_TRACE
#endif

namespace plumb {

constinit thread_local std::string_view Running::current;

namespace {

struct Signal {
    int number;
    std::string_view text;
};
constexpr std::array kSignals{
    Signal{SIGSEGV, "SIGSEGV, a wrong access to memory"}, Signal{SIGBUS, "SIGBUS, a wrong access to memory"},
    Signal{SIGFPE, "SIGFPE, e.g. a division of integers by zero"},
    Signal{SIGILL, "SIGILL, an invalid instruction"},
    Signal{SIGABRT, "SIGABRT, a failed assertion, an exception that is not caught, or damaged memory"}};

constexpr int kFrames = 64;            // of a back trace
constexpr int kOwnFrames = 2;          // report(), and the system's function that calls it
constexpr std::size_t kStack = 65536;  // bytes: the report of a stack overflow needs another stack

std::array<char, 512> remedyText{};  // filled before a crash, when memory can be allocated no more
std::size_t remedySize = 0;

// Everything below runs in a signal handler: it calls only functions that are safe there, but for
// backtrace(), which may wait for a lock of the loader while another thread loads a library.

void print(std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
        if (written <= 0) return;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

void printBackTrace() {
#if defined(PLUMB_BACK_TRACE)
    std::array<void*, kFrames> frames{};
    const int count = backtrace(frames.data(), kFrames);
    print("back trace, innermost function first (c++filt makes the names readable):\n");
    if (count > kOwnFrames)
        backtrace_symbols_fd(frames.data() + kOwnFrames, count - kOwnFrames, STDERR_FILENO);
#endif
}

void report(int number) {
    print("\nplumb: the program crashed: ");
    for (const Signal& signal : kSignals) {
        if (signal.number == number) print(signal.text);
    }
    print("\nrunning: ");
    print(Running::current.empty() ? "no system or handler" : Running::current);
    print("\n");
    print({remedyText.data(), remedySize});
    print("\n");
    printBackTrace();  // last, because it may fail if the stack is damaged
    raise(number);     // the former action follows when this function returns, see SA_RESETHAND
}

}  // namespace

void reportCrashes(std::string_view remedy) {
    remedySize = std::min(remedy.size(), remedyText.size());
    std::copy_n(remedy.begin(), remedySize, remedyText.begin());
#if defined(PLUMB_BACK_TRACE)
    std::array<void*, 1> frame{};
    backtrace(frame.data(), 1);  // the first call allocates memory
#endif
    static std::array<char, kStack> memory;
    stack_t stack{};
    stack.ss_sp = memory.data();
    stack.ss_size = memory.size();
    if (sigaltstack(&stack, nullptr) != 0) return;
    for (const Signal& signal : kSignals) {
        struct sigaction known {};
        if (sigaction(signal.number, nullptr, &known) != 0 || known.sa_handler != SIG_DFL) continue;
        struct sigaction action {};
        action.sa_handler = report;
        action.sa_flags = static_cast<int>(SA_ONSTACK | SA_RESETHAND);
        sigaction(signal.number, &action, nullptr);
    }
}

}  // namespace plumb
