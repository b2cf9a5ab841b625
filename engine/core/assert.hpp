#pragma once

namespace plumb {

/// Called when a PLUMB_ASSERT fails. The default prints the sentence and aborts.
using AssertHandler = void (*)(const char* sentence, const char* file, int line);

/// Replaces the handler, so that a test can expect a failed assertion; returns the previous one.
AssertHandler setAssertHandler(AssertHandler handler);

void failAssertion(const char* sentence, const char* file, int line);

}  // namespace plumb

/// kAssertions: a failed PLUMB_ASSERT calls the handler.
#if !defined(NDEBUG) || defined(PLUMB_ASSERTS)
namespace plumb {
inline constexpr bool kAssertions = true;
}
#define PLUMB_ASSERT(condition, sentence) \
    ((condition) ? static_cast<void>(0) : ::plumb::failAssertion(sentence, __FILE__, __LINE__))
#else
namespace plumb {
inline constexpr bool kAssertions = false;
}
#define PLUMB_ASSERT(condition, sentence) static_cast<void>(sizeof(!(condition)))
#endif
