#include "tests/accuracy/command/words.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace plumb::accuracy {

std::string readWords(std::span<const std::string_view> words, std::span<const Flag> flags,
                      const TakeOption& take) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto flag =
            std::find_if(flags.begin(), flags.end(), [&](const Flag& one) { return one.word == words[i]; });
        if (flag != flags.end()) {
            *flag->on = true;
            continue;
        }
        if (i + 1 == words.size()) return format("'{}' is an unknown option or has no value", words[i]);
        const std::string wrong = take(words[i], words[i + 1]);
        if (!wrong.empty()) return format("{} {}: {}", words[i], words[i + 1], wrong);
        ++i;
    }
    return {};
}

std::string readCount(std::string_view value, int most, int& count) {
    const auto number = parseInt(value);
    if (!number || *number < 1 || *number > most) return format("expected a whole number from 1 to {}", most);
    count = static_cast<int>(*number);
    return {};
}

}  // namespace plumb::accuracy
