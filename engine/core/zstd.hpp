#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/result.hpp"

namespace plumb {

/// Unpacks Zstandard frames (RFC 8878), checking the sum where one is given.
///
/// @param limit  bytes that may come out; more is an error, and nothing beyond is ever allocated
/// @param where  the name that stands before every error
/// @error        cut off, damaged, larger than the limit, a frame that needs a dictionary
Result<std::string> unpackZstd(std::string_view packed, std::size_t limit, std::string_view where);

}  // namespace plumb
