#pragma once

#include <string>
#include <string_view>

#include "core/result.hpp"
#include "reflect/json_fwd.hpp"
#include "reflect/json_text.hpp"

namespace plumb {

/// Encodes a JSON value as CBOR. Numbers that fit into a float take four bytes.
/// Source: RFC 8949, Concise Binary Object Representation.
std::string writeCbor(const Json& json);

/// Decodes the output of writeCbor and other CBOR that has a JSON form, with the limits of JSON text.
/// @error what was expected and what was found, with the byte offset
Result<Json> readCbor(std::string_view bytes, std::string_view where, const JsonLimits& limits = {});

}  // namespace plumb
