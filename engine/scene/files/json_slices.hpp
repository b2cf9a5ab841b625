#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace plumb {

/// Splits the text of a JSON object into its keys and the texts of its values, and an array into the texts of
/// its items, without parsing these. So one invalid entity does not make the file unreadable, and a large
/// file is never in memory as one tree. Keys keep their escape sequences.
///
/// @return nullopt if brackets, strings and commas do not form an object or an array
std::optional<std::vector<std::pair<std::string_view, std::string_view>>> sliceObject(std::string_view text);
std::optional<std::vector<std::string_view>> sliceArray(std::string_view text);

}  // namespace plumb
