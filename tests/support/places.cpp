#include "tests/support/places.hpp"

namespace plumb::test {

std::filesystem::path sourceFolder() { return PLUMB_SOURCE_DIR; }

}  // namespace plumb::test
