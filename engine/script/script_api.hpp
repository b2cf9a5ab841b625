#pragma once

#include <string>

namespace plumb {

class TypeRegistry;

/// Returns the definitions of everything that scripts can use, as a file for the Lua language server: with
/// it, editors of text complete and check scripts.
/// @param types  all component types, those of the project's scripts included
std::string scriptDefinitions(const TypeRegistry& types);

/// Returns tables of the handlers, properties and functions of scripts, in Markdown: the reference in
/// docs/scripting.md.
std::string scriptReference();

}  // namespace plumb
