#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "editor/model/assets/asset_catalog.hpp"
#include "editor/ui/fields/field_row.hpp"

namespace plumb::editor::ui {

inline constexpr const char* kEntityPayload = "plumb.entity";  ///< what is dragged: the ObjectId

/// Chooses an entity of the scene: from a list that is searched, by dragging one from the tree onto it, or by
/// dragging its aim onto one in the scene. One for a panel.
class EntityPicker {
public:
    void draw(const FieldRow& row);

private:
    void drawList(const FieldRow& row, bool first);
    void drawAim(const FieldRow& row);
    void drawGoTo(const FieldRow& row, ObjectId id);

    std::string search_;
    std::vector<ObjectId> found_;
};

/// Chooses a file of one kind: from a list with pictures that is searched, or by dropping one from the
/// assets.
class AssetPicker {
public:
    void draw(const FieldRow& row);

private:
    void drawList(const FieldRow& row, std::string_view now, bool first);
    static void set(const FieldRow& row, std::string_view path);

    std::string search_;
    std::vector<AssetItem> files_;  // of the kind, since the list was opened
};

}  // namespace plumb::editor::ui
