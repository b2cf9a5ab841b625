#pragma once

#include <string>
#include <string_view>

#include "core/result.hpp"
#include "reflect/json_fwd.hpp"
#include "reflect/json_text.hpp"

namespace plumb {

/// The binary twin of a JSON value. Numbers that a float holds take its four bytes.
/// Source: RFC 8949, Concise Binary Object Representation.
std::string writeCbor(const Json& json);

/// Reads what writeCbor wrote, or what else of CBOR has a JSON form, under the limits of JSON text.
/// @error what was expected and what was found, with the byte's place
Result<Json> readCbor(std::string_view bytes, std::string_view where, const JsonLimits& limits = {});

}  // namespace plumb
