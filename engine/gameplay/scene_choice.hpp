#pragma once

#include "ecs/world.hpp"
#include "gameplay/components/controls/menu_item.hpp"
#include "gameplay/components/controls/save_slot.hpp"
#include "gameplay/game_functions.hpp"
#include "scene/scene_requests.hpp"

namespace plumb {

/// The slot of a menu item or a SceneKey that saves or loads: that of its SaveSlot, else 1.
inline int saveSlotOf(const World& world, EntityId asker) {
    const auto* own = world.find<SaveSlot>(asker);
    return own == nullptr ? 1 : own->slot;
}

/// Requests what a menu item or a SceneKey does.
/// @param asker  entity of the item or the key
inline void choose(World& world, EntityId asker, MenuAction action, SceneId scene) {
    auto& requests = world.resource<SceneRequests>();
    switch (action) {
        case MenuAction::Close: requests.close = true; break;
        case MenuAction::GoTo:
        case MenuAction::Open:
            requests.next = scene.path;
            requests.overlay = action == MenuAction::Open;
            break;
        case MenuAction::Restart: requests.reload = true; break;
        case MenuAction::Quit: requests.quit = true; break;
        case MenuAction::Save: saveGame(world, saveSlotOf(world, asker)); break;
        case MenuAction::Load: loadGame(world, saveSlotOf(world, asker)); break;
        case MenuAction::Options: showOptions(world); break;
    }
}

}  // namespace plumb
