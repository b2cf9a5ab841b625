#pragma once

#include <string_view>

namespace plumb {

/// What an importer notes beside what is ours: meant to be there, kept and written back, read by people only.
constexpr bool isImportNote(std::string_view key) {
    return key == "tiled" || key == "ldtk" || key == "aseprite";
}

}  // namespace plumb
