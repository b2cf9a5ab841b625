#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "reflect/json_fwd.hpp"

namespace plumb {

// Access to JSON of unknown structure. The accessors of the JSON library (value, get, at,
// operator[] of a constant object) throw or read out of bounds if a file contains another type
// than expected; these return nothing instead. Readers that have to report errors use JsonFields.

/// Null if `json` is not an object or has no such member.
const Json* findMember(const Json& json, std::string_view key);
Json* findMember(Json& json, std::string_view key);
/// The member; null if it is missing or not an object.
const Json* findObject(const Json& json, std::string_view key);
Json* findObject(Json& json, std::string_view key);
/// The member; null if it is missing or not an array.
const Json* findArray(const Json& json, std::string_view key);
Json* findArray(Json& json, std::string_view key);
/// The member's string; null if it is missing or not a string.
const std::string* findText(const Json& json, std::string_view key);

/// The value's string; null if it is not a string.
const std::string* jsonText(const Json& json);
/// A copy of the value's string; empty if it is not a string.
std::string stringOrEmpty(const Json& json);
/// The number; nothing if the value is not a number, or outside the range of a float.
std::optional<float> floatOf(const Json& json);
/// The integer; nothing if the value is not a number, has a fraction, or is outside the range of an int.
std::optional<int> intOf(const Json& json);
/// The 64-bit number that a string of hex digits contains; 0 if the value is not such a string.
std::uint64_t hexIdOf(const Json& json);
/// hexIdOf() of a member; 0 also if the member is missing.
std::uint64_t hexIdIn(const Json& json, std::string_view key);

/// Returns the member; if it is missing or not an object, it first becomes an empty object. If `json`
/// itself is not an object, it first becomes an empty one too.
Json& makeObject(Json& json, std::string_view key);

/// Returns a value's JSON text on one line. Invalid UTF-8, e.g. in file names, is replaced.
std::string compactText(const Json& json);

}  // namespace plumb
