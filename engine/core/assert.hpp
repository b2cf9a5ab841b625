#pragma once

namespace plumb {

/// Called when a PLUMB_ASSERT fails. The default prints the sentence and aborts.
using AssertHandler = void (*)(const char* sentence, const char* file, int line);

/// Replaces the handler, so that a test can expect a failed assertion; returns the previous one.
AssertHandler setAssertHandler(AssertHandler handler);

void failAssertion(const char* sentence, const char* file, int line);

}  // namespace plumb

#if !defined(NDEBUG) || defined(PLUMB_ASSERTS)
#define PLUMB_ASSERT(condition, sentence) \
    ((condition) ? static_cast<void>(0) : ::plumb::failAssertion(sentence, __FILE__, __LINE__))
#else
#define PLUMB_ASSERT(condition, sentence) static_cast<void>(sizeof(!(condition)))
#endif
