#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "codec/xml.hpp"
#include "core/result.hpp"
#include "import/tiled_map.hpp"

namespace plumb {

/// Reads the `<data>` of a layer into its cells: XML tiles, csv or base64, packed or not, whole or in chunks.
/// For chunks the layer's place and size become the box around them all.
///
/// @param layer  states its size; gets the cells
/// @param room   cells that may still be read for this map; what was read is taken away
/// @error        another count of cells than the size says, damaged data, an unknown encoding
Result<Done> readTmxCells(const XmlElement& data, tiled::Layer& layer, std::size_t& room,
                          std::string_view where);

}  // namespace plumb
