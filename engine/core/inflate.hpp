#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/result.hpp"

namespace plumb {

/// Decompresses a zlib stream (RFC 1950) and verifies its checksum.
///
/// @param limit  maximum output in bytes; more is an error, and never allocated
/// @param where  prefix of all errors
/// @error truncated, damaged, larger than the limit, a preset dictionary
Result<std::string> unpackZlib(std::string_view packed, std::size_t limit, std::string_view where);

/// Decompresses the first member of a gzip file (RFC 1952) and verifies its checksum and length.
Result<std::string> unpackGzip(std::string_view packed, std::size_t limit, std::string_view where);

}  // namespace plumb
