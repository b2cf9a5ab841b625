#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/limits.hpp"
#include "core/result.hpp"
#include "reflect/json_fwd.hpp"

namespace plumb {

/// What a text may be at most to be read. The defaults are the limits of the house.
struct JsonLimits {
    std::size_t bytes = limits::kFileBytes;
    int depth = limits::kJsonDepth;              ///< objects and arrays inside each other
    std::size_t textBytes = limits::kTextBytes;  ///< of one text
    std::size_t values = limits::kJsonValues;    ///< numbers, texts, objects, … in all
};

/// Reads JSON text from outside: strict, in UTF-8, without recursion past the limit and without exceptions.
///
/// @param where     the file's name; the error's place is "where:line:column"
/// @param warnings  when given, a repeated key adds a warning and its last value counts; else it is an error
/// @error           what was expected and what was found instead
Result<Json> parseJson(std::string_view text, std::string_view where, std::vector<Error>* warnings = nullptr,
                       const JsonLimits& limits = {});

/// The one way in which files of a project are written: two spaces, one property a line, arrays of numbers or
/// short words on one line while they fit, a newline at the end. A number that came from a float takes the
/// shortest text that reads back to it, so reading and writing again changes no byte.
std::string writeJson(const Json& json);

/// For files that are long lists of small things, tiles and frames of animations: whatever fits stands on one
/// line.
std::string writeCompactJson(const Json& json);

/// The same without the newline at the end, for a value that stands `indent` spaces deep inside a larger
/// text.
void appendJson(std::string& out, const Json& json, std::size_t indent);

}  // namespace plumb
