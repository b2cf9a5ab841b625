#include <plumb.hpp>

using namespace plumb;

struct LevelKeys {
    SceneId pause;  ///< scene of the pause menu

    static void describe(TypeBuilder<LevelKeys>& type) {
        type.name("LevelKeys").doc("R begins the level again, the action Pause opens the pause menu.");
        type.field<&LevelKeys::pause>("pause").doc("Scene of the pause menu.");
    }
};

struct LevelKeySystem {
    void update(World& world, float) {
        // While an overlay is open the level is paused, and this query finds nothing: the overlay has the
        // keys.
        for (auto [entity, keys] : world.query<const LevelKeys>()) {
            if (!world.resource<SceneRequests>().empty()) return;  // e.g. the game has ended in this tick
            const Input& input = inputFor(world, entity);
            if (input.isPressed(Key::R)) restartScene(world);
            if (input.isPressed(Action::Pause)) showOverlay(world, keys.pause);
        }
    }
};

void addLevelKeys(Module& module) {
    module.components<LevelKeys>();
    module.system<LevelKeySystem, LevelKeys>();
}
