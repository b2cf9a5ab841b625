#pragma once

#include <string>

#include "core/text_store.hpp"
#include "editor/model/name_filter.hpp"
#include "editor/ui/ui.hpp"
#include "reflect/type_info.hpp"

namespace plumb::editor::ui {

/// Chooses an entity of the scene, or nobody.
bool pickEntity(Ui& ui, const std::string& path, ObjectId& id);

/// Chooses a file of the project of one kind, or none.
bool pickAsset(Ui& ui, const std::string& path, AssetKind kind, TextId& id);

}  // namespace plumb::editor::ui
