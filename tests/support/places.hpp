#pragma once

#include <filesystem>

namespace plumb::test {

/// The checkout that the tests were built from. Known when a program is linked, so that the objects of all
/// tests are the same in every checkout, and a cache of compiled files serves them all.
std::filesystem::path sourceFolder();

}  // namespace plumb::test
