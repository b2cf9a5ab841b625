#pragma once

#include <string_view>

#include "assets/asset_store.hpp"
#include "core/result.hpp"

namespace plumb::editor {

/// Reads a picture, sound or font to its end, as a game does when it first shows or plays it: the store looks
/// at their beginning only.
/// @error  a game could not use it
Result<Done> checkContent(AssetKind kind, std::string_view bytes, std::string_view where);

}  // namespace plumb::editor
