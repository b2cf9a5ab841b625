#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "import/tiled_map.hpp"
#include "import/loaders/xml.hpp"

namespace plumb {

/// Reads the `<data>` of a layer to its cells: XML tiles, CSV or base64, with or without compression and
/// chunks. For chunks, sets the layer's position and size to the box around all of them.
///
/// @param layer  receives the cells; its size must be set before, if there are no chunks
/// @param room   number of cells that may still be read for this map; reduced by those read
/// @error        the number of cells does not match the size, damaged data, or an unknown encoding
Result<Done> readTmxCells(const XmlElement& data, tiled::Layer& layer, std::size_t& room,
                          std::string_view where);

}  // namespace plumb
