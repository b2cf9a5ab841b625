#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/limits.hpp"
#include "core/result.hpp"
#include "reflect/json_fwd.hpp"

namespace plumb {

/// Limits on a JSON text. The defaults are those of limits.hpp.
struct JsonLimits {
    std::size_t bytes = limits::kFileBytes;
    int depth = limits::kJsonDepth;              ///< nesting of objects and arrays
    std::size_t textBytes = limits::kTextBytes;  ///< bytes of one string
    std::size_t values = limits::kJsonValues;    ///< total number of numbers, strings, objects, …
};

/// Parses external JSON text: strict, in UTF-8, with limited recursion and without exceptions.
/// @param where  the file's name; Error::where is "where:line:column"
/// @param warnings  if not null, a repeated key adds a warning and its last value is used; else
/// it is an error
/// @error what was expected and what was found instead
Result<Json> parseJson(std::string_view text, std::string_view where, std::vector<Error>* warnings = nullptr,
                       const JsonLimits& limits = {});

/// Writes the standard format of project files: two spaces, one property per line, arrays of numbers or short
/// words on one line if they fit, a newline at the end. Numbers that came from floats are written as
/// the shortest text that is read back to the same value, so reading and writing again changes no byte.
std::string writeJson(const Json& json);

/// Writes files that are long lists of small values (tiles, animation
/// frames): every value that fits is on one line.
std::string writeCompactJson(const Json& json);

/// Appends the text of writeJson() without the final newline, for
/// a value at an indentation of `indent` spaces.
void appendJson(std::string& out, const Json& json, std::size_t indent);

}  // namespace plumb
