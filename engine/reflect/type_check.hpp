#pragma once

#include <vector>

#include "core/result.hpp"
#include "reflect/type_info.hpp"

namespace plumb {

/// Returns the mistakes in the description of a type: names that are missing or used twice, a member that is
/// described twice, ranges without values, defaults outside of them. Their places are `component "Spin"` and
/// `component "Spin", field "rate"`.
std::vector<Error> mistakesOf(const TypeInfo& type);

}  // namespace plumb
