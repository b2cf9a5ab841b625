#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "core/hash.hpp"

namespace plumb {

/// The id of a text: a hash of its characters, so the same text has the same id everywhere,
/// and a component with a TextId stays trivially copyable. 0 is the empty text.
struct TextId {
    std::uint64_t value = 0;

    [[nodiscard]] bool empty() const { return value == 0; }
    friend bool operator==(TextId, TextId) = default;
};

constexpr TextId textId(std::string_view text) { return {text.empty() ? 0 : hashText(text)}; }

/// Maps ids to texts. Only grows; the order of insertion has no visible effect.
class TextStore {
public:
    TextStore();

    TextId add(std::string_view text);

    /// The text of an id; empty if it was never added here.
    [[nodiscard]] std::string_view find(TextId id) const;
    [[nodiscard]] std::string_view find(std::uint64_t id) const { return find(TextId{id}); }
    [[nodiscard]] std::size_t size() const { return texts_.size(); }
    /// All texts, in the order in which they were added.
    [[nodiscard]] const std::deque<std::string>& all() const { return texts_; }

    TextStore(const TextStore& other);
    TextStore& operator=(const TextStore& other);
    TextStore(TextStore&&) noexcept = default;
    TextStore& operator=(TextStore&&) noexcept = default;

private:
    struct Slot {
        std::uint64_t id = 0;
        const std::string* text = nullptr;
    };

    [[nodiscard]] std::size_t slotOf(std::uint64_t id) const;
    void grow();

    std::deque<std::string> texts_;  // a deque, so that views stay valid
    std::vector<Slot> slots_;        // open addressing, a power of two
};

}  // namespace plumb
