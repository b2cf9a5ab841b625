#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/hash.hpp"

namespace plumb {

/// What the game puts in place of {words} in labels, beside those that fillPlaceholders knows. Texts that
/// change belong here: the store of a world's texts keeps each text that a Label ever had. A resource, in
/// snapshots and in the hash.
struct LabelValues {
    std::vector<std::pair<std::string, std::string>> values;  ///< by word

    void set(std::string_view word, std::string_view text);
    /// Null when the game has not set it.
    [[nodiscard]] const std::string* find(std::string_view word) const;
    void addTo(Hasher& hasher) const;
};

}  // namespace plumb
