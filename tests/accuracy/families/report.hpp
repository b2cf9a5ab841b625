#pragma once

#include <string>
#include <vector>

#include "core/file.hpp"
#include "core/result.hpp"
#include "tests/accuracy/families/run.hpp"

namespace plumb::families {

std::string textOf(const FamilyResult& result);               ///< plain text for the terminal
std::string csvOf(const std::vector<FamilyResult>& results);  ///< a row per family and relation
std::string htmlOf(const std::vector<FamilyResult>& results, const std::string& how);
std::string markdownOf(const std::vector<FamilyResult>& results, const std::string& how);

}  // namespace plumb::families
