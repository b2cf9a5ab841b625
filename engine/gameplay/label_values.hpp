#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/hash.hpp"

namespace plumb {

/// Texts with which game code replaces {words} in labels, in addition to the placeholders of
/// fillPlaceholders(). Use it for changing texts, as a world's text store keeps every text that a Label ever
/// had. A world resource, included in snapshots and hash.
struct LabelValues {
    std::vector<std::pair<std::string, std::string>> values;  ///< word and text, sorted by word

    void set(std::string_view word, std::string_view text);
    /// Returns the text for a word; null if it is not set.
    [[nodiscard]] const std::string* find(std::string_view word) const;
    void addTo(Hasher& hasher) const;
};

}  // namespace plumb
