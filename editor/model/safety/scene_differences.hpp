#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plumb::editor {

/// Returns the differences between two texts of a scene for display, one per line, e.g. "crate:
/// Transform.position was [200, 64], is [210, 64]". A single line reports a text that is not a valid scene.
/// @param most  maximum number of lines; if there are more, a last line reports how many
std::vector<std::string> sceneDifferences(std::string_view before, std::string_view after,
                                          std::size_t most = 200);

}  // namespace plumb::editor
