#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "editor/model/prefabs/prefab_edit.hpp"
#include "editor/model/shared_components.hpp"
#include "editor/ui/fields/field_edit.hpp"

namespace plumb::editor::ui {

/// One component of what is selected: its title with its menu, and a row for each field.
class ComponentView {
public:
    /// What is selected; each in the world that is shown as well.
    struct Selected {
        const std::vector<ObjectId>& ids;
        const std::vector<EntityId>& entities;
        const PrefabOverrides& overrides;  ///< how the one selected last differs from its prefab
    };

    /// @pre all of them have the component
    void draw(Ui& ui, const TypeInfo& type, const Selected& selected);
    /// After all were drawn: does what was asked for. Only now, as components that are being drawn must not
    /// come, go or move in memory.
    void endFrame(Ui& ui);
    /// The same for others.
    void ask(std::function<void(Workspace& workspace)> what) { asked_ = std::move(what); }

private:
    struct Shown {
        Ui& ui;
        const TypeInfo& type;
        const std::vector<ObjectId>& ids;
        const PrefabOverrides& overrides;
        const std::vector<EntityId>& entities;
        ComponentState fresh;  ///< with its defaults
    };

    struct Found {
        SharedField shared;
        bool visible = false;
    };

    /// What the widget shows. Found out once for each change of the scene, as thousands may be selected.
    const Found& find(const Shown& shown, const FieldInfo& field);
    void drawFields(const Shown& shown);
    void drawMenu(const Shown& shown, bool differs);
    void drawField(const Shown& shown, const FieldInfo& field);
    void drawFieldMenu(const FieldRow& row, const Shown& shown);
    /// An arrow at the end of the name: back to the default, or to the prefab.
    void drawReset(const FieldRow& row, const Shown& shown, float end);
    void reset(const FieldRow& row, const Shown& shown);
    void prefabItems(Ui& ui, const std::string& path, const PrefabScope& scope, bool differs);

    FieldEdit fields_;
    std::map<const FieldInfo*, Found> found_;  // as it was at `looked_`
    HeldComponents held_;                      // of the one being drawn, once one of its fields is looked at
    SelectedState looked_;
    std::function<void(Workspace& workspace)> asked_;
};

/// The bar beside what differs from the prefab.
void drawPrefabBar(const Ui& ui, ImVec2 from, float height);

}  // namespace plumb::editor::ui
