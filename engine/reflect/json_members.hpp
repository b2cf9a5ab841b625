#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "reflect/json_fwd.hpp"

namespace plumb {

// Access to JSON of unknown shape. The accessors of the JSON library that convert (value, get of a text, at,
// operator[] of a constant object) throw or read past the end when a file holds another type than expected;
// these return nothing instead. A reader that has to report what is wrong uses JsonFields.

/// Null when `json` is no object or has no such member.
const Json* findMember(const Json& json, std::string_view key);
Json* findMember(Json& json, std::string_view key);
/// The member; null when it is missing or no object.
const Json* findObject(const Json& json, std::string_view key);
Json* findObject(Json& json, std::string_view key);
/// The member; null when it is missing or no array.
const Json* findArray(const Json& json, std::string_view key);
Json* findArray(Json& json, std::string_view key);
/// The member's text; null when it is missing or no text.
const std::string* findText(const Json& json, std::string_view key);

/// Null when the value is no text.
const std::string* jsonText(const Json& json);
/// A copy of the text; empty when the value is no text.
std::string textOrEmpty(const Json& json);
/// Nothing when the value is no number, or beyond the range of a float.
std::optional<float> floatOf(const Json& json);
/// Nothing when the value is no number, has a fraction, or is beyond the range of an int.
std::optional<int> wholeOf(const Json& json);
/// The 64 bits written as hex digits; 0 when the value is no such text.
std::uint64_t hexIdOf(const Json& json);
/// The same of a member; 0 also when it is missing.
std::uint64_t hexIdIn(const Json& json, std::string_view key);

/// The member as an object: one that is missing or of another type becomes an empty object.
/// `json` becomes an object too when it is none.
Json& makeObject(Json& json, std::string_view key);

/// The value on one line. A text that is not UTF-8, as names of files may be, is written with substitutes.
std::string compactText(const Json& json);

}  // namespace plumb
