#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/result.hpp"

namespace plumb {

/// Unpacks a zlib stream (RFC 1950) and checks its sum.
///
/// @param limit  bytes that may come out; more is an error, and nothing beyond is ever allocated
/// @param where  the name that stands before every error
/// @error        cut off, damaged, larger than the limit, a preset dictionary
Result<std::string> unpackZlib(std::string_view packed, std::size_t limit, std::string_view where);

/// Unpacks the first member of a gzip file (RFC 1952) and checks its sum and length.
Result<std::string> unpackGzip(std::string_view packed, std::size_t limit, std::string_view where);

}  // namespace plumb
