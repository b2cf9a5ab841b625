#include <plumb.hpp>

using namespace plumb;

// The code of this game. The editor builds it when you save this file, and loads it into the running game.

/// A character that the player moves. The inspector shows the fields, scenes save them.
struct Walker {
    float speed = 200.0f;  ///< px/s, walking speed
    float jump = 420.0f;   ///< px/s, speed at the start of a jump

    static void describe(TypeBuilder<Walker>& type) {
        type.name("Walker").doc("A character that walks with the arrow keys and jumps with Space.");
        type.field<&Walker::speed>("speed")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 2000.0f)
            .doc("Walking speed, px/s.");
        type.field<&Walker::jump>("jump")
            .unit(Unit::PixelsPerSecond)
            .range(0.0f, 2000.0f)
            .doc("Speed at the start of a jump, px/s.");
    }
};

/// Moves an entity back to its initial position when it falls out of the level.
struct ComeBack {
    float below = 400.0f;  ///< px: y below which the entity is moved back
    Vec2 home;             ///< px: initial position, to which it is moved back
    bool hasHome = false;  ///< `home` has been set

    static void describe(TypeBuilder<ComeBack>& type) {
        type.name("ComeBack").doc("Moves the entity back to its initial position when it falls.");
        type.field<&ComeBack::below>("below").unit(Unit::Pixels).doc("Moves it back from below this y, px.");
        type.field<&ComeBack::home>("home").transient();
        type.field<&ComeBack::hasHome>("hasHome").transient();
    }
};

/// Event: an entity fell out of the level. Systems and functions can react to it.
struct Fell {
    EntityId entity;
};

/// Moves the Walkers by the player's input. Systems run in every tick, 60 times a second.
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

static void reportFall(World&, const Fell&) { logNote("Game", "The player fell and was moved back"); }

/// Registers the components, systems and event handlers above with the engine.
PLUMB_MODULE(module) {
    module.components<Walker, ComeBack>();
    module.system<WalkerSystem, Walker>(before<PhysicsSystem>());
    module.system<ComeBackSystem, ComeBack>();
    module.on<Fell, reportFall>();
}
