#pragma once

#include <string_view>

namespace plumb {

/// True for keys that importers add as notes: kept and written back, but without effect.
constexpr bool isImportNote(std::string_view key) {
    return key == "tiled" || key == "ldtk" || key == "aseprite";
}

}  // namespace plumb
