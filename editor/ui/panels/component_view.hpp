#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "editor/model/prefabs/prefab_edit.hpp"
#include "editor/model/shared_components.hpp"
#include "editor/ui/fields/field_edit.hpp"

namespace plumb::editor::ui {

/// Inspector section for one component type of the selected
/// entities: a header with a menu, and a row per field.
class ComponentView {
public:
    /// The ids of the selected objects, and their entities in
    /// the shown world (the scene, or the running game).
    struct Selected {
        const std::vector<ObjectId>& ids;
        const std::vector<EntityId>& entities;
        const PrefabOverrides& overrides;  ///< what differs between the entities and their prefabs
    };

    /// @pre every selected entity has the component
    void draw(Ui& ui, const TypeInfo& type, const Selected& selected);
    /// Runs the requested change. Call it after all components were drawn: adding or removing a component
    /// while drawing would invalidate references to components.
    void endFrame(Ui& ui);
    /// Requests a change of the workspace that endFrame() will run.
    void ask(std::function<void(Workspace& workspace)> what) { asked_ = std::move(what); }

private:
    struct Shown {
        Ui& ui;
        const TypeInfo& type;
        const std::vector<ObjectId>& ids;
        const PrefabOverrides& overrides;
        const std::vector<EntityId>& entities;
        ComponentState fresh;  ///< the component with default values
    };

    struct Found {
        SharedField shared;
        bool visible = false;
    };

    /// Returns the value that the field's widget shows. The result is cached until the scene or the selection
    /// changes, because thousands of entities may be selected.
    const Found& find(const Shown& shown, const FieldInfo& field);
    void drawFields(const Shown& shown);
    void drawMenu(const Shown& shown, bool differs);
    void drawField(const Shown& shown, const FieldInfo& field);
    void drawFieldMenu(const FieldRow& row, const Shown& shown);
    /// Draws the arrow button after the field's name, which
    /// resets the field to the default or the prefab's value.
    void drawReset(const FieldRow& row, const Shown& shown, float end);
    void reset(const FieldRow& row, const Shown& shown);
    void prefabItems(Ui& ui, const std::string& path, const PrefabScope& scope, bool differs);

    FieldEdit fields_;
    std::map<const FieldInfo*, Found> found_;  // cache, valid for the state `looked_`
    HeldComponents held_;  // the selected entities' components of the drawn type; read with its first field
    SelectedState looked_;
    std::function<void(Workspace& workspace)> asked_;  // requested by ask(); null: none
};

/// Draws the vertical bar that marks a difference from the prefab.
void drawPrefabBar(const Ui& ui, ImVec2 from, float height);

}  // namespace plumb::editor::ui
