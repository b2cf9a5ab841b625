#include <plumb.hpp>

using namespace plumb;

struct TopDownMover {
    float speed = 150.0f;  ///< px/s

    static void describe(TypeBuilder<TopDownMover>& type) {
        type.name("TopDownMover").doc("Moves a RigidBody by the arrow keys, WASD or a stick.");
        type.field<&TopDownMover::speed>("speed").unit(Unit::PixelsPerSecond).range(0.0f, 2000.0f);
    }
};

struct TopDownSystem {
    void update(World& world, float) {
        for (auto [entity, mover, body] : world.query<const TopDownMover, RigidBody>()) {
            const Input& input = inputFor(world, entity);
            const Vec2 way{input.getAxis(Axis::Horizontal), input.getAxis(Axis::Vertical)};
            // Two keys at once are as fast as one; a stick that is pushed a little is slower.
            body.velocity = (length(way) > 1.0f ? normalized(way) : way) * mover.speed;
        }
    }
};

void addTopDown(Module& module) {
    module.components<TopDownMover>();
    module.system<TopDownSystem, TopDownMover>(before<PhysicsSystem>());
}
