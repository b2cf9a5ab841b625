#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace plumb {

/// Splits the text of a JSON object into the texts of its values, and that of an array into those of its
/// items, without looking inside: so that one broken entity does not take its file with it, and a large
/// file is never in memory as one tree. Keys keep their escapes.
///
/// @return nothing when brackets, texts and commas do not make an object or an array
std::optional<std::vector<std::pair<std::string_view, std::string_view>>> sliceObject(std::string_view text);
std::optional<std::vector<std::string_view>> sliceArray(std::string_view text);

}  // namespace plumb
