#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace plumb::script {

/// Matches patterns of Lua (reference manual 6.4.1) in a limited number of steps: with several `.-` or `.*` a
/// pattern of Lua's own library can take hours. Plain data without a destructor.
class PatternMatcher {
public:
    static constexpr int kMaxCaptures = 32;
    static constexpr int kMaxDepth = 200;                 ///< of nested items that may be repeated
    static constexpr std::int64_t kMaxSteps = 2'000'000;  ///< of one call of the library: some 10 ms

    enum class Problem : std::uint8_t {
        None,
        TooManySteps,
        TooComplex,
        Malformed,
        TooManyCaptures,
        BadCapture
    };

    struct Capture {
        std::size_t begin = 0;
        std::size_t length = 0;
        bool isPosition = false;
        bool isOpen = false;
    };

    PatternMatcher(std::string_view text, std::string_view pattern) : text_{text}, pattern_{pattern} {}

    /// Tries the pattern, without its anchor, at a position of the text.
    /// @return the end of the match, or kNone
    std::size_t match(std::size_t at);
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    /// What is wrong with the pattern; nothing matches then.
    /// Steps of all matches so far.
    [[nodiscard]] std::int64_t steps() const { return steps_; }
    [[nodiscard]] Problem problem() const { return problem_; }
    [[nodiscard]] int captureCount() const { return captureCount_; }
    [[nodiscard]] const Capture& capture(int index) const {
        return captures_[static_cast<std::size_t>(index)];
    }

private:
    std::size_t matchFrom(std::size_t at, std::size_t item);
    std::size_t matchSpecial(std::size_t at, std::size_t item, bool& isSpecial);
    std::size_t matchBalanced(std::size_t at, std::size_t item);
    std::size_t matchFrontier(std::size_t at, std::size_t item);
    std::size_t matchBack(std::size_t at, std::size_t item);
    std::size_t openCapture(std::size_t at, std::size_t item, bool isPosition);
    std::size_t closeCapture(std::size_t at, std::size_t item);
    std::size_t matchMost(std::size_t at, std::size_t item, std::size_t after);
    std::size_t matchLeast(std::size_t at, std::size_t item, std::size_t after);
    [[nodiscard]] std::size_t endOfItem(std::size_t item);
    [[nodiscard]] bool matchesOne(std::size_t at, std::size_t item, std::size_t end);
    bool spend(std::size_t steps);
    [[nodiscard]] bool inSet(unsigned char c, std::size_t open, std::size_t close) const;
    std::size_t fail(Problem problem) { return problem_ = problem, kNone; }

    std::string_view text_;
    std::string_view pattern_;
    std::array<Capture, kMaxCaptures> captures_{};
    int captureCount_ = 0;
    int depth_ = 0;
    std::int64_t steps_ = 0;
    Problem problem_ = Problem::None;
};

}  // namespace plumb::script
