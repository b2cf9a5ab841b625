#pragma once

#include <string_view>

#include "assets/asset_store.hpp"
#include "core/result.hpp"

namespace plumb::editor {

/// Reads an image, sound or font completely, as a game does on first use; AssetStore reads only the header.
/// @param where  name of the file for messages. @error  the file is invalid
Result<Done> checkContent(AssetKind kind, std::string_view bytes, std::string_view where);

}  // namespace plumb::editor
