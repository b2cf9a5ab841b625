#include <array>
#include <set>
#include <string>

#include "core/text.hpp"
#include "editor/model/actions/action_rows.hpp"
#include "editor/model/commands/insert_entities.hpp"
#include "editor/model/document/prefab_root.hpp"
#include "editor/model/document/root_place.hpp"
#include "editor/model/prefabs/instance_changes.hpp"
#include "editor/model/prefabs/prefab_visit.hpp"
#include "editor/model/tools/transform_drag.hpp"
#include "editor/model/tree_edit.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/drawing/particle_emitter.hpp"
#include "scene/components/name.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/transform.hpp"

namespace plumb::editor {
namespace {

/// Returns a name that no entity has yet: "new entity", "new entity 2".
std::string freeName(const Document& document, const std::string& wanted) {
    std::set<std::string, std::less<>> taken;
    for (const ObjectId id : document.objects()) taken.insert(document.nameOf(id));
    std::string name = wanted;
    for (int number = 2; taken.contains(name); ++number) name = format("{} {}", wanted, number);
    return name;
}

void create(Workspace& w) {
    const Vec2 at = snapped(w.view.view().center, w.grid.size);
    w.undo.push(createEntity(w.document, freeName(w.document, "new entity"), at));
    w.undo.endGesture();
}
/// Creates an entity with one component (and a Transform) in the center of the view.
template <class T>
void createWith(Workspace& w, const std::string& wanted, const T& component) {
    Document& document = w.document;
    const std::string name = freeName(document, wanted);
    EntityState state{document.newId(), {}, {}};
    const auto add = [&]<class Part>(const Part& part) {
        state.components.push_back(componentState(document, document.types().of<Part>(), &part));
    };
    add(SceneEntity{state.id.value, document.nextOrder(), document.scene});
    add(Name{document.world.texts().add(name)});
    add(Transform{snapped(w.view.view().center, w.grid.size)});
    add(component);
    std::vector<EntityState> states{std::move(state)};
    belowPrefabRoot(document, states);
    w.undo.push(std::make_unique<InsertEntities>(format("create {}", name), std::move(states)));
    w.undo.endGesture();
}
void createParticles(Workspace& w) { createWith(w, "particles", ParticleEmitter{}); }
void createCamera(Workspace& w) { createWith(w, "camera", Camera{}); }
void nudgeOrSay(Workspace& w, Vec2 offset) {
    nudge(w.tools(), offset);
    if (onlyRootSelected(w.document)) w.notice = kRootCannotMove;
}
template <int X, int Y>
void nudgeBy(Workspace& w) {
    nudgeOrSay(w, {static_cast<float>(X), static_cast<float>(Y)});
}
template <int X, int Y>
void nudgeGrid(Workspace& w) {
    nudgeOrSay(w, scaled({static_cast<float>(X), static_cast<float>(Y)}, w.grid.size));
}

// Visibility and locks of the selected entities in the editor.

template <void (EntityView::*Set)(ObjectId, bool), bool (EntityView::*Is)(ObjectId) const>
void switchView(Workspace& w) {
    EntityView& view = w.document.view;
    const bool now = (view.*Is)(w.document.selection.all().back());
    for (const ObjectId id : w.document.selection.all()) (view.*Set)(id, !now);
}
template <bool (EntityView::*Is)(ObjectId) const>
bool isInView(const Workspace& w) {
    return anySelection(w) && (w.document.view.*Is)(w.document.selection.all().back());
}
void showAll(Workspace& w) {
    const ObjectId solo = w.document.view.solo();
    w.document.view.clear();
    if (solo) w.document.view.toggleSolo(solo);
}
bool hidesAny(const Workspace& w) { return editable(w) && !w.document.view.showsAll(); }
void group(Workspace& w) {
    if (!groupEntities(w.document, w.undo, w.document.selection.all()))
        w.notice = "Parts of a prefab instance cannot be moved in the tree";
}
template <int By>
void stepInTreeBy(Workspace& w) {
    if (!stepInTree(w.document, w.undo, w.document.selection.all().back(), By))
        w.notice = "The entity is already first or last among its siblings, or is a part of a prefab";
}

bool onInstance(const Workspace& w) { return withSelection(w) && w.selectsInstance(); }
bool changedInstance(const Workspace& w) { return onInstance(w) && instancesDiffer(w); }
bool comesFromPrefab(const Workspace& w) { return onInstance(w) && !selectedPrefab(w).empty(); }
bool canLeavePrefab(const Workspace& w) { return w.canEdit() && !fileToReturnTo(w).empty(); }

const std::array kRows{
    Action{"entity.create", "Entity", "Create entity", control(Key::N), editable, create},
    Action{"entity.camera", "Entity", "Add camera", {}, editable, createCamera},
    Action{"entity.particles", "Entity", "Add particles", {}, editable, createParticles},
    Action{"entity.prefab", "Entity", "Add prefab...", control(Key::N, true), editable,
           ask<WindowRequest::ChoosePrefab>},
    Action{"entity.rename",
           "Entity",
           "Rename",
           {Key::F2},
           withSelection,
           [](Workspace& w) {
               w.panelToShow = "Scene", w.settings.layout.hidden = false;
               ask<WindowRequest::RenameSelected>(w);
           }},
    Action{"entity.group", "Entity", "Group", control(Key::G), withSelection, group},
    Action{"entity.earlier",
           "Entity",
           "Move up in the tree",
           {Key::Up, false, false, true},
           withSelection,
           stepInTreeBy<-1>},
    Action{"entity.later",
           "Entity",
           "Move down in the tree",
           {Key::Down, false, false, true},
           withSelection,
           stepInTreeBy<1>},
    line("Entity"),
    Action{"entity.hide",
           "Entity",
           "Hide in the editor",
           control(Key::H),
           withSelection,
           switchView<&EntityView::setHidden, &EntityView::isHidden>,
           isInView<&EntityView::isHidden>,
           {},
           During::Entities},
    Action{"entity.lock",
           "Entity",
           "Lock",
           control(Key::L),
           withSelection,
           switchView<&EntityView::setLocked, &EntityView::locks>,
           isInView<&EntityView::locks>,
           {},
           During::Entities},
    Action{"entity.showAll", "Entity", "Show and unlock all", {Key::H, true, false, true}, hidesAny, showAll},
    line("Entity"),
    Action{
        "entity.makePrefab", "Entity", "Make prefab...", {}, withSelection, ask<WindowRequest::NamePrefab>},
    Action{"entity.editPrefab", "Entity", "Edit prefab", control(Key::E), comesFromPrefab,
           [](Workspace& w) { askToEditPrefab(w, selectedPrefab(w)); }},
    Action{"entity.leavePrefab", "Entity", "Leave prefab", control(Key::E, true), canLeavePrefab,
           askToLeavePrefab},
    Action{"entity.overrides",
           "Entity",
           "Prefab overrides...",
           {},
           onInstance,
           ask<WindowRequest::ShowOverrides>},
    Action{"entity.revert", "Entity", "Revert to prefab", control(Key::R), changedInstance,
           [](Workspace& w) { w.revertToPrefab(); }},
    Action{"entity.apply", "Entity", "Apply to prefab", control(Key::R, true), changedInstance,
           [](Workspace& w) { w.applyToPrefab(); }},
    line("Entity"),
    Action{"entity.left", "Entity", "Nudge left", {Key::Left}, withSelection, nudgeBy<-1, 0>},
    Action{"entity.right", "Entity", "Nudge right", {Key::Right}, withSelection, nudgeBy<1, 0>},
    Action{"entity.up", "Entity", "Nudge up", {Key::Up}, withSelection, nudgeBy<0, -1>},
    Action{"entity.down", "Entity", "Nudge down", {Key::Down}, withSelection, nudgeBy<0, 1>},
    Action{"entity.gridLeft", "Entity", "One cell left", shifted(Key::Left), withSelection, nudgeGrid<-1, 0>},
    Action{"entity.gridRight", "Entity", "One cell right", shifted(Key::Right), withSelection,
           nudgeGrid<1, 0>},
    Action{"entity.gridUp", "Entity", "One cell up", shifted(Key::Up), withSelection, nudgeGrid<0, -1>},
    Action{"entity.gridDown", "Entity", "One cell down", shifted(Key::Down), withSelection, nudgeGrid<0, 1>},
};

}  // namespace

std::span<const Action> entityActions() { return kRows; }

}  // namespace plumb::editor
