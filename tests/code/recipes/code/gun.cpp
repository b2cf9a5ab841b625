#include <plumb.hpp>

using namespace plumb;

struct Gun {
    PrefabId bullet;         ///< with a RigidBody or a KinematicBody, and a Lifetime
    float speed = 600.0f;    ///< px/s, of a bullet
    float interval = 0.2f;   ///< s, between two shots
    float distance = 20.0f;  ///< px, from the gun to a new bullet
    float wait = 0.0f;       ///< s, until the next shot is possible

    static void describe(TypeBuilder<Gun>& type) {
        type.name("Gun").doc("Shoots at the mouse while the action Attack is held.");
        type.field<&Gun::bullet>("bullet").doc("Prefab of a bullet.");
        type.field<&Gun::speed>("speed").unit(Unit::PixelsPerSecond).range(1.0f, 5000.0f);
        type.field<&Gun::interval>("interval").unit(Unit::Seconds).range(0.02f, 10.0f);
        type.field<&Gun::distance>("distance").unit(Unit::Pixels).range(0.0f, 1000.0f);
        type.field<&Gun::wait>("wait").unit(Unit::Seconds).transient();
    }
};

struct GunSystem {
    void update(World& world, float dt) {
        for (auto [entity, gun] : world.query<Gun>()) {
            gun.wait = std::max(0.0f, gun.wait - dt);
            if (gun.wait > 0.0f || !inputFor(world, entity).isHeld(Action::Attack)) continue;
            gun.wait = gun.interval;
            const Vec2 from = worldPose(world, entity).position;
            const Vec2 aim = mouseInWorld(world) - from;
            const Vec2 way = aim == Vec2{} ? Vec2{1.0f, 0.0f} : normalized(aim);  // the mouse is on the gun
            const Entity bullet = spawn(world, gun.bullet, from + way * gun.distance);
            if (!bullet) continue;  // no prefab is chosen, or its file is wrong, which spawn() has reported
            if (RigidBody* body = bullet.find<RigidBody>()) body->velocity = way * gun.speed;
            if (KinematicBody* body = bullet.find<KinematicBody>()) body->velocity = way * gun.speed;
        }
    }
};

void addGuns(Module& module) {
    module.components<Gun>();
    module.system<GunSystem, Gun>(before<PhysicsSystem>());
}
