#pragma once

#include <string>
#include <string_view>

#include "core/file.hpp"

namespace plumb::accuracy {

/// Escapes text for XML and HTML.
std::string escaped(std::string_view text);

/// A self-contained page of tables; dark if the reader's desktop is.
/// @param body  HTML; cells of the classes "good" and "bad" are green and red
std::string tablePage(std::string_view title, std::string_view body);

/// Writes a file, or reports on stderr why it cannot.
bool write(const Path& path, std::string_view text);

}  // namespace plumb::accuracy
