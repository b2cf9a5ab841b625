#include "gameplay/systems/shortcut_system.hpp"

#include "ecs/world.hpp"
#include "gameplay/components/controls/scene_key.hpp"
#include "gameplay/components/controls/toggle_key.hpp"
#include "gameplay/named_action.hpp"
#include "gameplay/scene_choice.hpp"
#include "input/input.hpp"
#include "scene/components/drawing/hidden.hpp"
#include "scene/scene_stack.hpp"

namespace plumb {

void ShortcutSystem::update(World& world, float) {
    for (auto [entity, key] : world.query<const SceneKey>()) {
        if (inputFor(world, entity).isPressed(actionNamed(key.action)))
            choose(world, entity, key.does, key.scene);
    }
    for (auto [entity, key] : world.query<const ToggleKey>()) {
        if (!inputFor(world, entity).isPressed(actionNamed(key.action))) continue;
        if (world.has<Hidden>(entity)) {
            world.remove<Hidden>(entity);
        } else {
            world.add<Hidden>(entity);
        }
    }
}

}  // namespace plumb
