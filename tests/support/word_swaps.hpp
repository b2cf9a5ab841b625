#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/type_swaps.hpp"

namespace plumb::test {

/// All variants of a valid text file in which one word is replaced by one of kStrangers.
class WordSwaps {
public:
    explicit WordSwaps(std::string_view text) : text_{text} {
        constexpr std::string_view kSpace = " \n\r\t";
        for (std::size_t at = text_.find_first_not_of(kSpace); at != std::string::npos;) {
            const std::size_t end = std::min(text_.find_first_of(kSpace, at), text_.size());
            words_.push_back({at, end});
            at = text_.find_first_not_of(kSpace, end);
        }
    }

    [[nodiscard]] std::size_t count() const { return words_.size() * kStrangers.size(); }
    [[nodiscard]] std::string name(std::size_t index) const {
        return format("word {} = {}", index / kStrangers.size(),
                      std::string{kStrangers[index % kStrangers.size()]});
    }
    [[nodiscard]] std::string text(std::size_t index) const {
        const auto& [begin, end] = words_[index / kStrangers.size()];
        std::string text = text_.substr(0, begin);
        text += kStrangers[index % kStrangers.size()];
        return text += text_.substr(end);
    }

private:
    static constexpr std::array<std::string_view, 9> kStrangers{
        "", "word", "7", "-7", "99999999999999999999", "-1e300", "nan", "+Right", "{}"};

    std::string text_;
    std::vector<std::pair<std::size_t, std::size_t>> words_;
};

}  // namespace plumb::test
