#include "editor/model/cost/scene_physics_edit.hpp"

#include <algorithm>
#include <memory>

#include "core/text.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/edit_fields.hpp"
#include "editor/model/input/key_words.hpp"
#include "editor/model/workspace.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/scene_entity.hpp"

namespace plumb::editor {
namespace {

/// Returns the entity with the active ScenePhysics, which is the first one; null if there is none.
ObjectId holderOf(const Workspace& workspace) {
    ObjectId holder;
    workspace.shownWorld().each<const ScenePhysics>([&](EntityId entity, const ScenePhysics&) {
        if (!holder) holder = workspace.shownNames().idOf(entity);
    });
    return holder;
}

/// Returns the entity to which a ScenePhysics is added: the first camera, else the first entity.
ObjectId entityForNewOne(const Workspace& workspace) {
    const Document& document = workspace.document;
    for (const ObjectId id : document.objects()) {
        if (document.world.has<Camera>(document.find(id)) && workspace.shownEntity(id)) return id;
    }
    for (const ObjectId id : document.objects()) {
        if (workspace.shownEntity(id)) return id;
    }
    return {};
}

void setField(void* component, const FieldInfo& field, const FieldValue& value) {
    std::memcpy(field.in(component), value.bytes.data(), value.bytes.size());
}

void addScenePhysics(Workspace& workspace, const CostRemedy& remedy, ScenePhysics physics) {
    const TypeInfo& type = workspace.document.types().of<ScenePhysics>();
    const ObjectId holder = entityForNewOne(workspace);
    if (!holder) return;
    if (workspace.play.running()) {
        // The first edit adds a default component, so only fields that differ from the default need edits.
        const ComponentState fresh = defaultComponent(type);
        setField(&physics, *type.find(remedy.field), remedy.value);
        for (const FieldInfo& field : type.fields) {
            const FieldValue value = readField(workspace.document, field, &physics);
            if (field.name == remedy.field ||
                value != readField(workspace.document, field, fresh.bytes.data()))
                workspace.play.edit(holder, type, field, value);
        }
        return;
    }
    setField(&physics, *type.find(remedy.field), remedy.value);
    std::vector<ChangeComponents::Change> changes;
    changes.push_back({holder, componentState(workspace.document, type, &physics)});
    workspace.undo.push(std::make_unique<ChangeComponents>(format("set {}.{}", remedy.type, remedy.field),
                                                           type, std::move(changes)));
}

}  // namespace

bool isAddedOnEdit(const TypeInfo& type) { return type.name == "ScenePhysics"; }

ScenePhysics presentPhysics(const physics::Settings& settings, PixelScale scale) {
    ScenePhysics present;
    present.gravity = toPixels(settings.gravity, scale);
    present.quality = settings.quality;
    present.integrator = settings.integrator;
    present.iterations = settings.iterations;
    present.automaticQuality = settings.automaticQuality;
    present.tolerance = settings.tolerance * scale.pixels;
    present.continuous = settings.continuous;
    present.sleeping = settings.sleeping;
    return present;
}

void takePresent(const Workspace& workspace, PixelScale scale, physics::Settings& settings) {
    const ObjectId holder = holderOf(workspace);
    if (!holder) return;
    const auto& present = workspace.shownWorld().get<ScenePhysics>(workspace.shownEntity(holder));
    settings.quality = qualityOf(std::max(present.quality, 0));
    settings.integrator = present.integrator;
    settings.iterations = static_cast<std::uint8_t>(std::clamp(present.iterations, 1, 64));
    settings.automaticQuality = present.automaticQuality;
    settings.tolerance = std::max(present.tolerance, 0.0f) * scale.metres;
    settings.continuous = present.continuous;
    settings.sleeping = present.sleeping;
}

CostRemedy qualityRemedy(int quality) {
    return {format("Use quality {}", quality), "ScenePhysics", "quality", FieldValue::of(quality), {}};
}

void applyRemedy(Workspace& workspace, const CostRemedy& remedy, const ScenePhysics& present) {
    const TypeInfo* type = workspace.document.types().find(remedy.type);
    const FieldInfo* field = type == nullptr ? nullptr : type->find(remedy.field);
    if (field == nullptr) return;
    workspace.undo.endGesture();
    std::vector<ObjectId> objects = remedy.objects;
    if (objects.empty()) objects.push_back(holderOf(workspace));
    if (!objects.front()) {
        addScenePhysics(workspace, remedy, present);
    } else {
        editFields(workspace, {*type, *field, objects},
                   [&](FieldValue& value, std::size_t) { value = remedy.value; });
    }
    workspace.undo.endGesture();
    workspace.notice =
        workspace.play.running()
            ? format("{}: changed in the running game; you can keep it when the game stops", remedy.label)
            : format("{}; press {} to undo", remedy.label, keysFor(workspace, "edit.undo"));
}

}  // namespace plumb::editor
