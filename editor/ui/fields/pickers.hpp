#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "editor/model/assets/asset_catalog.hpp"
#include "editor/ui/fields/field_row.hpp"

namespace plumb::editor::ui {

inline constexpr const char* kEntityPayload = "plumb.entity";  ///< type of a drag payload: an ObjectId

/// Widget that selects an entity of the scene: from a searchable list, by dropping one from the scene tree,
/// or by dragging its target icon onto one in the scene view. One object per panel.
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

/// Widget that selects a file of one kind: from a searchable list with previews, or by dropping one from the
/// Assets panel.
class AssetPicker {
public:
    void draw(const FieldRow& row);

private:
    void drawList(const FieldRow& row, std::string_view now, bool first);
    static void set(const FieldRow& row, std::string_view path);

    std::string search_;
    std::vector<AssetItem> files_;  // all files of the kind, read when the list was opened
};

}  // namespace plumb::editor::ui
