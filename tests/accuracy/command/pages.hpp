#pragma once

#include <string>
#include <string_view>

#include "core/file.hpp"

namespace plumb::accuracy {

/// Escapes text for XML and HTML.
std::string escaped(std::string_view text);

/// Returns a JSON string, with its quotes. Control characters are left out.
std::string quotedForJson(std::string_view text);

/// Returns a self-contained HTML page of tables; uses dark colors on a dark desktop.
/// @param body  HTML; cells of the classes "good" and "bad" are green and red
std::string tablePage(std::string_view title, std::string_view body);

/// Writes a file. @return false after an error, which is printed to stderr
bool write(const Path& path, std::string_view text);

}  // namespace plumb::accuracy
