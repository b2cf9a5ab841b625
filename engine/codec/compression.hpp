#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/result.hpp"

namespace plumb {

/// Packs bytes as a zlib stream (RFC 1950).
std::string packZlib(std::string_view bytes);

/// Unpacks a zlib stream and checks its checksum. Data after the stream is ignored.
///
/// @param limit  maximum number of unpacked bytes; no memory beyond it is allocated
/// @param where  name of the data, the prefix of every error
/// @error        truncated, damaged, larger than the limit, a preset dictionary
Result<std::string> unpackZlib(std::string_view packed, std::size_t limit, std::string_view where);

/// Unpacks the first member of a gzip file (RFC 1952) and checks its checksum and length.
/// Parameters and errors are those of unpackZlib().
Result<std::string> unpackGzip(std::string_view packed, std::size_t limit, std::string_view where);

/// Unpacks Zstandard frames (RFC 8878) and checks the checksum of those that have one.
/// Parameters and errors are those of unpackZlib().
Result<std::string> unpackZstd(std::string_view packed, std::size_t limit, std::string_view where);

}  // namespace plumb
