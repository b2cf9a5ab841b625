#pragma once

#include <nlohmann/json_fwd.hpp>

namespace plumb {

using Json = nlohmann::ordered_json;

}  // namespace plumb
