#pragma once

#include <string_view>

#include "core/result.hpp"
#include "import/loaders/xml.hpp"

namespace plumb {

/// Converts a Tiled file in JSON format to the elements of the XML format, so that one reader serves both.
/// @param element  name of the root element: "map", "tileset" or "template"
Result<XmlElement> tmjToXml(std::string_view text, std::string_view element, std::string_view where);

}  // namespace plumb
