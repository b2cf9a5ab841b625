#pragma once

#include <string>
#include <string_view>

#include "core/result.hpp"

namespace plumb {

/// Decodes base64 (RFC 4648, standard alphabet). White space is skipped, padding is optional.
/// @error a character outside the alphabet, text after the padding, an invalid length
Result<std::string> bytesFromBase64(std::string_view text, std::string_view where);

/// Encodes bytes as base64, with padding, without line breaks.
std::string toBase64(std::string_view bytes);

// The same with '-' and '_' instead of '+' and '/' and without padding (base64url, RFC 4648): for addresses.

Result<std::string> bytesFromBase64Url(std::string_view text, std::string_view where);
std::string toBase64Url(std::string_view bytes);

}  // namespace plumb
