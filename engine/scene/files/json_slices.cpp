#include "scene/files/json_slices.hpp"

#include <string>

#include "core/limits.hpp"

namespace plumb {
namespace {

constexpr std::string_view kBlank = " \t\r\n";

class Slicer {
public:
    explicit Slicer(std::string_view text) : text_{text} {}

    [[nodiscard]] bool ended() const { return at_ >= text_.size(); }
    void skipBlank() { at_ = std::min(text_.find_first_not_of(kBlank, at_), text_.size()); }
    bool take(char c) {
        skipBlank();
        if (ended() || text_[at_] != c) return false;
        ++at_;
        return true;
    }

    std::optional<std::string_view> takeText() {
        skipBlank();
        const std::size_t start = at_;
        if (ended() || text_[at_] != '"') return std::nullopt;
        for (++at_; at_ < text_.size(); ++at_) {
            if (text_[at_] == '\\') {
                ++at_;
            } else if (text_[at_] == '"') {
                ++at_;
                return text_.substr(start, at_ - start);
            }
        }
        return std::nullopt;
    }

    std::optional<std::string_view> takeValue() {
        skipBlank();
        const std::size_t start = at_;
        if (!ended() && text_[at_] == '"') return takeText();
        std::string open;  // stack of the closing brackets expected
        while (!ended()) {
            const char c = text_[at_];
            if (c == '"') {
                if (!takeText()) return std::nullopt;
                continue;
            }
            if (c == '{' || c == '[') {
                if (open.size() > static_cast<std::size_t>(limits::kJsonDepth)) return std::nullopt;
                open += c == '{' ? '}' : ']';
            } else if (c == '}' || c == ']') {
                if (open.empty()) break;
                if (open.back() != c) return std::nullopt;
                open.pop_back();
                if (open.empty()) {
                    ++at_;
                    break;
                }
            } else if (open.empty() && (c == ',' || kBlank.find(c) != std::string_view::npos)) {
                break;
            }
            ++at_;
        }
        if (!open.empty() || at_ == start) return std::nullopt;
        return text_.substr(start, at_ - start);
    }

private:
    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace

std::optional<std::vector<std::pair<std::string_view, std::string_view>>> sliceObject(std::string_view text) {
    std::vector<std::pair<std::string_view, std::string_view>> slices;
    Slicer slicer{text};
    if (!slicer.take('{')) return std::nullopt;
    if (!slicer.take('}')) {
        do {
            const auto key = slicer.takeText();
            if (!key || !slicer.take(':')) return std::nullopt;
            const auto value = slicer.takeValue();
            if (!value) return std::nullopt;
            slices.emplace_back(key->substr(1, key->size() - 2), *value);
        } while (slicer.take(','));
        if (!slicer.take('}')) return std::nullopt;
    }
    slicer.skipBlank();
    return slicer.ended() ? std::optional{std::move(slices)} : std::nullopt;
}

std::optional<std::vector<std::string_view>> sliceArray(std::string_view text) {
    std::vector<std::string_view> slices;
    Slicer slicer{text};
    if (!slicer.take('[')) return std::nullopt;
    if (!slicer.take(']')) {
        do {
            const auto value = slicer.takeValue();
            if (!value) return std::nullopt;
            slices.push_back(*value);
        } while (slicer.take(','));
        if (!slicer.take(']')) return std::nullopt;
    }
    slicer.skipBlank();
    return slicer.ended() ? std::optional{std::move(slices)} : std::nullopt;
}

}  // namespace plumb
