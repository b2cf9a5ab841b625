#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/result.hpp"

namespace plumb {

/// Decompresses Zstandard frames (RFC 8878), and verifies the checksum if there is one.
///
/// @param limit  maximum output in bytes; more is an error, and never allocated
/// @param where  prefix of all errors
/// @error truncated, damaged, larger than the limit, a frame that needs a dictionary
Result<std::string> unpackZstd(std::string_view packed, std::size_t limit, std::string_view where);

}  // namespace plumb
