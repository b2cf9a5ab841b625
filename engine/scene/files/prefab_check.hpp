#pragma once

#include <cstdint>
#include <vector>

#include "core/result.hpp"
#include "reflect/json_fwd.hpp"

namespace plumb {

class TypeRegistry;
struct Prefab;

/// Returns the problems in the content of a prefab file: keys, components and fields that do not exist,
/// values of a wrong type, references to entities that the prefab does not have. What skipped an entity or an
/// override is in Prefab::problems.
/// @param nested  for each entity of the file the prefab of which it is an instance, or null
/// @param rootId  id of the root in the file
std::vector<Error> checkPrefab(const TypeRegistry& types, const Prefab& prefab, const Json& file,
                               const std::vector<const Prefab*>& nested, std::uint64_t rootId);

}  // namespace plumb
