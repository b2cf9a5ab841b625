#include "tests/accuracy/reference_error.hpp"

namespace plumb::accuracy {

std::optional<double> referenceError(std::string_view /*scene*/, const physics::World& /*start*/,
                                     const physics::World& /*end*/, double /*seconds*/) {
    return std::nullopt;
}

}  // namespace plumb::accuracy
