#include <plumb.hpp>

using namespace plumb;

// The code of this game. The editor builds it when you save this file, and loads it into the running game.

/// A character that the player moves. The inspector shows the fields, scenes save them.
struct Walker {
    float speed = 200.0f;  ///< px/s
    float jump = 420.0f;   ///< px/s

    static void describe(TypeBuilder<Walker>& type) {
        type.name("Walker").doc("A character that the arrow keys move and Space lets jump.");
        type.field<&Walker::speed>("speed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 2000.0f)
            .doc("Speed, px/s.");
        type.field<&Walker::jump>("jump")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 2000.0f)
            .doc("Speed at the start of a jump, px/s.");
    }
};

/// Brings an entity back to where it was when it falls out of the level.
struct ComeBack {
    float below = 400.0f;  ///< px
    Vec2 home;             ///< px
    bool hasHome = false;

    static void describe(TypeBuilder<ComeBack>& type) {
        type.name("ComeBack").doc("Brings the entity back to its start when it falls out of the level.");
        type.field<&ComeBack::below>("below").unit(Unit::Pixels).doc("Height below which it comes back, px.");
        type.field<&ComeBack::home>("home").transient();
        type.field<&ComeBack::hasHome>("hasHome").transient();
    }
};

/// An event: others can react to it.
struct Fell {
    EntityId entity;
};

/// Systems run in every tick, 60 times a second.
struct WalkerSystem {
    void update(World& world, float) {
        for (auto [entity, walker, body] : world.query<const Walker, RigidBody>()) {
            const Input& input = inputFor(world, entity);
            body.velocity.x = input.getAxis(Axis::Horizontal) * walker.speed;
            if (body.grounded && input.isPressed(Action::Jump)) body.velocity.y = -walker.jump;
        }
    }
};

struct ComeBackSystem {
    void update(World& world, float) {
        for (auto [entity, back, transform] : world.query<ComeBack, Transform>()) {
            if (!back.hasHome) {
                back.home = transform.position;
                back.hasHome = true;
            } else if (transform.position.y > back.below) {
                teleport(transform, back.home);
                if (RigidBody* body = world.find<RigidBody>(entity)) body->velocity = {};
                world.emit(Fell{entity});
            }
        }
    }
};

static void reportFall(World&, const Fell&) { logNote("Game", "The player fell and comes back"); }

/// The list of everything above that the game uses.
PLUMB_MODULE(module) {
    module.components<Walker, ComeBack>();
    module.system<WalkerSystem, Walker>(before<PhysicsSystem>());
    module.system<ComeBackSystem, ComeBack>();
    module.on<Fell, reportFall>();
}
