#pragma once

#include <nlohmann/json.hpp>

namespace plumb {

/// A JSON value that keeps the order of its keys: files read in the order they were written.
using Json = nlohmann::ordered_json;

}  // namespace plumb
