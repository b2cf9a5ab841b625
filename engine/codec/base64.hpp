#pragma once

#include <string>
#include <string_view>

#include "core/result.hpp"

namespace plumb {

/// Bytes of base64 text (RFC 4648, standard alphabet). White space is skipped, padding may be missing.
/// @error a character that is not of the alphabet, text after the padding, a length that no bytes have
Result<std::string> bytesFromBase64(std::string_view text, std::string_view where);

/// With padding, without line breaks.
std::string toBase64(std::string_view bytes);

}  // namespace plumb
