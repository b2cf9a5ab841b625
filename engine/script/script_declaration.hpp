#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "reflect/type_info.hpp"

struct lua_State;

namespace plumb::script {

/// Adds `script {...}`, which declares the component of a file, and the properties number, integer, boolean,
/// text, vector, color, entity, choice, list and those of assets, to a new state.
void addDeclarations(lua_State* state);

/// To be called before a file is run: pushes the declaration of the file that runs now, which may require the
/// other.
void beginDeclaration(lua_State* state);
/// To be called after a file has run, with what beginDeclaration() pushed on top of the stack.
/// @param file  name under which the declaration is found by declaredType()
void endDeclaration(lua_State* state, std::string_view file);

/// True if the file has called script().
bool isDeclared(lua_State* state, std::string_view file);
/// Returns the component type that the file declared: its properties are the fields, after `stopped`, a Bool
/// that is true after an error.
/// @param name   of the component
/// @param texts  receives texts and paths that default values contain; a world needs them in its TextStore
/// @error a property is declared in a wrong way
Result<TypeInfo> declaredType(lua_State* state, std::string_view file, std::string_view name,
                              std::vector<std::string>& texts);

/// Returns the text with the same content that lives as long as the program.
std::string_view permanentText(std::string_view text);

}  // namespace plumb::script
