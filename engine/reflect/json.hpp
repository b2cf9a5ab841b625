#pragma once

#include <nlohmann/json.hpp>

namespace plumb {

/// A JSON value that preserves the order of keys, so that files keep their order.
using Json = nlohmann::ordered_json;

}  // namespace plumb
