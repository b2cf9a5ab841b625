#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plumb::editor {

/// What differs between two texts of a scene, one line each, for people: "crate: Transform.position was
/// [200, 64], is [210, 64]". Texts that are no scenes differ in one line that says so.
/// @param most  lines; a last one says how many more there are
std::vector<std::string> sceneDifferences(std::string_view before, std::string_view after,
                                          std::size_t most = 200);

}  // namespace plumb::editor
