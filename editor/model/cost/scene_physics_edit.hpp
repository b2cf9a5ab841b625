#pragma once

#include <string>
#include <vector>

#include "editor/model/document/field_value.hpp"
#include "physics/settings.hpp"
#include "scene/components/scene_physics.hpp"
#include "scene/physics/physics_units.hpp"

namespace plumb::editor {

class Workspace;

/// A change that advice comes to: one field, of the scene's physics or of some entities.
struct CostRemedy {
    std::string label;  ///< of the button; empty: there is nothing to click
    std::string type;   ///< of the component
    std::string field;
    FieldValue value;
    std::vector<ObjectId> objects;  ///< none: the entity with the scene's ScenePhysics
};

/// What a scene without a ScenePhysics has in fact.
ScenePhysics presentPhysics(const physics::Settings& settings, PixelScale scale);

/// Makes the change, as one step of undo, or at once in the game that plays, where it is offered for keeping
/// afterwards. A scene without ScenePhysics gets one, with all as it is but for this.
/// @param present  of the game that was measured
void applyRemedy(Workspace& workspace, const CostRemedy& remedy, const ScenePhysics& present);

/// Takes over what the shown scene's ScenePhysics says now, if it has one.
void takePresent(const Workspace& workspace, PixelScale scale, physics::Settings& settings);

/// The remedy that sets the quality of the scene, without automatic quality.
CostRemedy qualityRemedy(int quality);

/// Whether a field of this type may be set while the game plays on an entity that has no such component yet.
bool comesByItself(const TypeInfo& type);

}  // namespace plumb::editor
