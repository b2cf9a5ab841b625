#pragma once

#include "reflect/type_registry.hpp"

namespace plumb {

/// Returns a registry of all components of the engine, in
/// the order in which files and the inspector list them.
TypeRegistry engineTypes();

}  // namespace plumb
