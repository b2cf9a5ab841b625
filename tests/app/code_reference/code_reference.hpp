#pragma once

#include <string>

namespace plumb::test {

/// Returns docs/code-reference.md, made of the headers that plumb.hpp includes.
/// @param missing  receives what the table of contents names and no header has
std::string codeReference(std::string& missing);

}  // namespace plumb::test
