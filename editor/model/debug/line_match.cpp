#include "editor/model/debug/line_match.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace plumb::editor {
namespace {

using Lines = std::span<const std::string>;

constexpr std::size_t kMostCells = 4'000'000;  // of the table; a larger difference is a new text

/// Writes the numbers of the matched lines; the others keep 0.
/// @param first  lines before both parts, in the new text
void matchPart(Lines before, Lines after, std::size_t first, std::span<int> numbers) {
    if (before.empty() || after.empty() || before.size() > kMostCells / after.size()) return;
    // length[i, j]: longest common subsequence of before[i..] and after[j..]
    const std::size_t width = after.size() + 1;
    std::vector<std::uint32_t> length((before.size() + 1) * width);
    for (std::size_t i = before.size(); i-- > 0;) {
        for (std::size_t j = after.size(); j-- > 0;) {
            length[i * width + j] = before[i] == after[j]
                                        ? length[(i + 1) * width + j + 1] + 1
                                        : std::max(length[(i + 1) * width + j], length[i * width + j + 1]);
        }
    }
    for (std::size_t i = 0, j = 0; i < before.size() && j < after.size();) {
        if (before[i] == after[j]) {
            numbers[i++] = static_cast<int>(first + ++j);
        } else {
            length[(i + 1) * width + j] >= length[i * width + j + 1] ? ++i : ++j;
        }
    }
}

/// Gives the lines without a match the places between those of their neighbors.
void placeOthers(std::span<int> numbers, int lines) {
    int last = 0;  // number of the line before
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] == 0) {
            const auto next = std::find_if(numbers.begin() + static_cast<std::ptrdiff_t>(i), numbers.end(),
                                           [](int number) { return number != 0; });
            const int end = next == numbers.end() ? lines : *next;  // the last one possible
            numbers[i] = std::max(std::min(last + 1, end), 1);
        }
        last = numbers[i];
    }
}

}  // namespace

std::vector<int> linesAfterEdit(const std::vector<std::string>& before,
                                const std::vector<std::string>& after) {
    std::vector<int> numbers(before.size());
    const std::size_t least = std::min(before.size(), after.size());
    std::size_t head = 0;
    while (head < least && before[head] == after[head]) ++head;
    std::size_t tail = 0;
    while (tail < least - head && before[before.size() - 1 - tail] == after[after.size() - 1 - tail]) ++tail;
    for (std::size_t i = 0; i < head; ++i) numbers[i] = static_cast<int>(i + 1);
    for (std::size_t i = 1; i <= tail; ++i)
        numbers[before.size() - i] = static_cast<int>(after.size() - i + 1);
    const std::size_t middle = before.size() - head - tail;
    matchPart(Lines{before}.subspan(head, middle), Lines{after}.subspan(head, after.size() - head - tail),
              head, std::span{numbers}.subspan(head, middle));
    placeOthers(numbers, static_cast<int>(after.size()));
    return numbers;
}

}  // namespace plumb::editor
