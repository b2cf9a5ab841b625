#pragma once

#include <filesystem>

namespace plumb::test {

/// Returns the root folder of the source tree that the tests were built from. It is set at link time, so that
/// object files are identical in every checkout and can be shared by a compiler cache.
std::filesystem::path sourceFolder();

}  // namespace plumb::test
