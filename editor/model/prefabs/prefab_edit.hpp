#pragma once

#include "core/file.hpp"
#include "editor/model/document/prefab_instance.hpp"
#include "editor/model/document/undo_stack.hpp"

namespace plumb::editor {

/// The objects needed to copy changes between instances and prefabs. Each such change is one undo step.
struct PrefabEdit {
    Document& document;
    UndoStack& undo;
    PrefabLibrary* prefabs = nullptr;  ///< null: no project with prefabs is open; no change is made
    Path root{};                       ///< the project's folder
};

/// The part of an instance to revert or apply: the whole instance, one component of an entity, or one field.
struct PrefabScope {
    const TypeInfo* type = nullptr;  ///< type of the component; null: all components of the whole instance
    std::string_view field{};        ///< name of the field; empty: the whole component
};

/// Resets entities to the values of their prefabs. Without a type it resets the whole instances and restores
/// removed parts and components; the position and rotation of an instance stay.
/// @return false if there was nothing to revert
bool revertToPrefab(const PrefabEdit& edit, const std::vector<ObjectId>& ids, const PrefabScope& scope = {});

/// Restores a removed part of an instance, with its removed ancestors. @return false if `part` is not a
/// removed part
bool restorePart(const PrefabEdit& edit, ObjectId part);

/// Writes the overrides of an instance to its prefab's file, atomically. Other instances in the document
/// follow where they do not override the value. Undo restores the file. References to entities outside the
/// instance are not written to the prefab.
/// @error  not an instance, nothing to apply, or the file cannot be read or written; then nothing has changed
Result<Done> applyToPrefab(const PrefabEdit& edit, ObjectId id, const PrefabScope& scope = {});

/// Adds an instance of a prefab to the scene and selects it.
/// @error  the prefab cannot be read, or the edited prefab would contain itself
Result<Done> addInstance(const PrefabEdit& edit, std::string_view path, Vec2 position);

}  // namespace plumb::editor
