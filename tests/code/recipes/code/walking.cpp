#include <plumb.hpp>

using namespace plumb;

struct Walking {
    static void describe(TypeBuilder<Walking>& type) {
        type.name("Walking").doc("Plays the clips idle, run and jump of the Animator, by the RigidBody.");
    }
};

struct WalkingSystem {
    void update(World& world, float) {
        for (auto [entity, walking, body, sprite] : world.query<const Walking, const RigidBody, Sprite>()) {
            const bool moves = std::abs(body.velocity.x) > 5.0f;  // px/s
            if (moves) sprite.flipX = body.velocity.x < 0.0f;
            playClip(world, entity, !body.grounded ? "jump" : moves ? "run" : "idle");
        }
    }
};

void addWalking(Module& module) {
    module.components<Walking>();
    module.system<WalkingSystem, Walking>();
}
