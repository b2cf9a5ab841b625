#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/text.hpp"
#include "import/loaders/xml.hpp"
#include "tests/support/type_swaps.hpp"

namespace plumb::test {

/// All variants of a valid XML file with one attribute or element text replaced by one of kStrangers.
class AttributeSwaps {
public:
    explicit AttributeSwaps(std::string_view text) : text_{text} {
        EXPECT_TRUE(parseXml(text, "sample").ok());
        for (std::size_t at = text_.find('<'); at != std::string::npos; at = text_.find('<', at + 1))
            collect(at);
    }
    AttributeSwaps(const AttributeSwaps&) = delete;
    AttributeSwaps(AttributeSwaps&&) = delete;

    [[nodiscard]] std::size_t count() const { return values_.size() * kStrangers.size(); }
    /// Returns a description of the change: "object width at 812 = nan".
    [[nodiscard]] std::string name(std::size_t index) const {
        const Value& value = values_[index / kStrangers.size()];
        return format("{} at {} = {}", value.name, value.begin,
                      std::string{kStrangers[index % kStrangers.size()]});
    }
    [[nodiscard]] std::string text(std::size_t index) const {
        const Value& value = values_[index / kStrangers.size()];
        std::string text = text_.substr(0, value.begin);
        text += kStrangers[index % kStrangers.size()];
        return text += text_.substr(value.end);
    }

private:
    static constexpr std::array<std::string_view, 9> kStrangers{
        "", "word", "7", "-7", "16384", "99999999999999999999", "-1e300", "nan", "1,2 word"};
    struct Value {
        std::size_t begin = 0;
        std::size_t end = 0;
        std::string name;
    };

    static bool isNameEnd(char c) {
        return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '/' || c == '>';
    }

    /// Collects the attribute values of a tag, and the text after it.
    void collect(std::size_t tag) {
        if (tag + 1 >= text_.size() || text_[tag + 1] == '/' || text_[tag + 1] == '!') return;
        std::size_t at = tag + 1;
        while (at < text_.size() && !isNameEnd(text_[at])) ++at;
        const std::string element = text_.substr(tag + 1, at - tag - 1);
        while (at < text_.size() && text_[at] != '>') {
            if (text_[at] != '"') {
                ++at;
                continue;
            }
            const std::size_t close = text_.find('"', at + 1);
            if (close == std::string::npos) return;
            const std::size_t name = text_.find_last_of(" \n\r\t", at) + 1;
            values_.push_back({at + 1, close, element + " " + text_.substr(name, at - 1 - name)});
            at = close + 1;
        }
        if (element.front() == '?' || at >= text_.size() || text_[at - 1] == '/') return;
        const std::size_t next = std::min(text_.find('<', at), text_.size());
        if (!trimmed(std::string_view{text_}.substr(at + 1, next - at - 1)).empty())
            values_.push_back({at + 1, next, element + " text"});
    }

    std::string text_;
    std::vector<Value> values_;
};

}  // namespace plumb::test
