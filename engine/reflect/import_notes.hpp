#pragma once

#include <string_view>

namespace plumb {

/// True for keys with notes of importers. They are kept and written back, but have no effect.
constexpr bool isImportNote(std::string_view key) {
    return key == "tiled" || key == "ldtk" || key == "aseprite";
}

}  // namespace plumb
