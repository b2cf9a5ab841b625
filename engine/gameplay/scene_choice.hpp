#pragma once

#include "gameplay/components/controls/menu_item.hpp"
#include "scene/scene_requests.hpp"

namespace plumb {

/// Requests the scene change of a menu item or a SceneKey.
inline void choose(SceneRequests& requests, MenuAction action, SceneId scene) {
    switch (action) {
        case MenuAction::Close: requests.close = true; break;
        case MenuAction::GoTo:
        case MenuAction::Open:
            requests.next = scene.path;
            requests.overlay = action == MenuAction::Open;
            break;
        case MenuAction::Restart: requests.reload = true; break;
        case MenuAction::Quit: requests.quit = true; break;
    }
}

}  // namespace plumb
