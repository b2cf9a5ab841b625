#pragma once

#include <string_view>

#include "codec/xml.hpp"
#include "core/result.hpp"

namespace plumb {

/// The JSON form of a Tiled file as the elements that its XML form would have, so that one reader serves
/// both.
/// @param element  of the root: "map", "tileset" or "template"
Result<XmlElement> tmjToXml(std::string_view text, std::string_view element, std::string_view where);

}  // namespace plumb
