#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/hash.hpp"
#include "core/state_archive.hpp"

namespace plumb {

/// The texts of showText(), which replace {words} in labels; fillPlaceholders() lists the words that have
/// values without it. An own word counts before one of those. A world resource, included in snapshots and
/// hash.
struct LabelValues {
    std::vector<std::pair<std::string, std::string>> values;  ///< word and text, sorted by word

    /// Sets the text for a word, as showText() does.
    void set(std::string_view word, std::string_view text);
    /// Returns the text for a word; null if it is not set.
    [[nodiscard]] const std::string* find(std::string_view word) const;
    void addTo(Hasher& hasher) const;
    void archive(StateArchive& archive);
};

}  // namespace plumb
