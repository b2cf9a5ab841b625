#include "scene/systems/experiment_system.hpp"

#include <utility>

#include "ecs/world.hpp"
#include "input/input.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/experiment.hpp"
#include "scene/components/transform.hpp"
#include "scene/lab.hpp"
#include "scene/scene_stack.hpp"

namespace plumb {

namespace {

void remember(World& world, Lab& lab, EntityId experiment) {
    lab.experiment = experiment;
    lab.starts.clear();
    ++lab.run;
    for (auto [entity, body, transform] : std::as_const(world).query<const RigidBody, const Transform>()) {
        lab.starts.push_back({entity, transform, body});
    }
}

void beginAnew(World& world, Lab& lab) {
    ++lab.run;
    lab.sliderMoved = false;
    for (const LabStart& start : lab.starts) {
        if (!world.alive(start.entity)) continue;
        if (auto* transform = world.find<Transform>(start.entity)) {
            *transform = start.transform;
            teleport(*transform, start.transform.position);
        }
        if (auto* body = world.find<RigidBody>(start.entity)) *body = start.body;
    }
}

Action actionOf(const Experiment& experiment) {
    Action action{""};
    action.id = experiment.action;
    return action;
}

}  // namespace

void ExperimentSystem::update(World& world, float) {
    for (auto [entity, experiment] : world.query<const Experiment>()) {
        Lab& lab = world.resource<Lab>();
        if (lab.experiment != entity) {
            remember(world, lab, entity);
            return;
        }
        const bool asked = inputFor(world, entity).isPressed(actionOf(experiment));
        if (asked || (experiment.afterSlider && lab.sliderReleased)) beginAnew(world, lab);
        return;
    }
}

}  // namespace plumb
