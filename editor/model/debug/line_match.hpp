#pragma once

#include <string>
#include <vector>

namespace plumb::editor {

/// Follows lines through an edit of their text. Equal lines are matched in order, as many as possible; a line
/// that was rewritten keeps its place between its neighbors, a deleted one goes to the line that follows.
/// @return for each line of `before` its number in `after`, from 1; at least 1, also if `after` is empty
/// Cost: the product of the numbers of lines between the first and the last difference
/// Source: R. Wagner, M. Fischer, "The String-to-String Correction Problem", 1974 (longest common
/// subsequence)
std::vector<int> linesAfterEdit(const std::vector<std::string>& before,
                                const std::vector<std::string>& after);

}  // namespace plumb::editor
