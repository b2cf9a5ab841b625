#pragma once

#include "core/file.hpp"
#include "editor/model/document/prefab_instance.hpp"
#include "editor/model/document/undo_stack.hpp"

namespace plumb::editor {

/// Changes that go between instances and their prefabs. Each is one step of undo.
struct PrefabEdit {
    Document& document;
    UndoStack& undo;
    PrefabLibrary* prefabs = nullptr;  ///< null: there are no prefabs, and nothing happens
    Path root{};                       ///< the project's folder
};

/// What of an instance is reverted or applied: all of it, one component of one entity, or one field of it.
struct PrefabScope {
    const TypeInfo* type = nullptr;
    std::string_view field{};
};

/// Gives entities back what their prefabs say. Without a type the whole instance, with the parts and
/// components that were taken from it; where it stands stays its own.
/// @return false when there was nothing to revert
bool revertToPrefab(const PrefabEdit& edit, const std::vector<ObjectId>& ids, const PrefabScope& scope = {});

/// Brings back a part of an instance that was taken out, with what is above it. @return false when none was
bool restorePart(const PrefabEdit& edit, ObjectId part);

/// Writes what an instance has for itself into its prefab's file, at once and as a whole. Other instances in
/// the document follow where they had the prefab's value. Undo writes the file back as it was.
/// References to entities outside the instance stay with it.
/// @error  no prefab, nothing to apply, or the file cannot be read or written; nothing has changed then
Result<Done> applyToPrefab(const PrefabEdit& edit, ObjectId id, const PrefabScope& scope = {});

/// Puts an instance of a prefab into the scene and selects it.
/// @error  the prefab cannot be read
Result<Done> addInstance(const PrefabEdit& edit, std::string_view path, Vec2 position);

}  // namespace plumb::editor
