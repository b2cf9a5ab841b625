#include "core/assert.hpp"

#include <cstdio>
#include <cstdlib>

#include "core/crash_report.hpp"

namespace plumb {
namespace {

void printAndAbort(const char* sentence, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: %s\n", file, line, sentence);
    setCrashReason(sentence);
    std::abort();
}

AssertHandler currentHandler = &printAndAbort;

}  // namespace

AssertHandler setAssertHandler(AssertHandler handler) {
    AssertHandler before = currentHandler;
    currentHandler = handler != nullptr ? handler : &printAndAbort;
    return before;
}

void failAssertion(const char* sentence, const char* file, int line) { currentHandler(sentence, file, line); }

}  // namespace plumb
