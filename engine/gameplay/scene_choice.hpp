#pragma once

#include "ecs/world.hpp"
#include "gameplay/components/controls/menu_item.hpp"
#include "gameplay/components/controls/save_slot.hpp"
#include "gameplay/game_functions.hpp"
#include "scene/scene_requests.hpp"

namespace plumb {

/// Requests what a menu item or a SceneKey does.
/// @param asker  entity of the item or the key; a SaveSlot of it is the slot for Save and Load
inline void choose(World& world, EntityId asker, MenuAction action, SceneId scene) {
    const auto* own = std::as_const(world).find<SaveSlot>(asker);
    const int slot = own == nullptr ? 1 : own->slot;
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
        case MenuAction::Save: saveGame(world, slot); break;
        case MenuAction::Load: loadGame(world, slot); break;
        case MenuAction::Options: showOptions(world); break;
    }
}

}  // namespace plumb
