#pragma once

#include <string>
#include <vector>

#include "editor/model/document/field_value.hpp"
#include "physics/settings.hpp"
#include "scene/components/scene_physics.hpp"
#include "scene/physics/physics_units.hpp"

namespace plumb::editor {

class Workspace;

/// A change that an advice proposes: the value of one component field.
struct CostRemedy {
    std::string label;  ///< text of the button; empty: there is no button
    std::string type;   ///< component type
    std::string field;
    FieldValue value;
    std::vector<ObjectId> objects;  ///< entities to change; empty: the one with the scene's ScenePhysics
};

/// Returns a ScenePhysics component with these settings, for a scene that has no such component.
ScenePhysics presentPhysics(const physics::Settings& settings, PixelScale scale);

/// Applies the change as one undo step, or directly in the running game; the user can keep it when the game
/// stops. A scene without ScenePhysics gets one with the present settings and this change.
/// @param present  settings of the measured game
void applyRemedy(Workspace& workspace, const CostRemedy& remedy, const ScenePhysics& present);

/// Overwrites `settings` with the values of the shown scene's ScenePhysics, if it has one.
void takePresent(const Workspace& workspace, PixelScale scale, physics::Settings& settings);

/// Returns the remedy that sets the field ScenePhysics.quality.
CostRemedy qualityRemedy(int quality);

/// True if the running game adds a missing component of this type when one of its fields is set.
bool isAddedOnEdit(const TypeInfo& type);

}  // namespace plumb::editor
