#include "gameplay/systems/player_controller_system.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ecs/world.hpp"
#include "gameplay/character_motion.hpp"
#include "gameplay/components/player_controller.hpp"
#include "gameplay/components/respawn.hpp"
#include "gameplay/sound_cue.hpp"
#include "input/input.hpp"
#include "math/portable.hpp"
#include "scene/components/box_collider.hpp"
#include "scene/components/character_body.hpp"
#include "scene/components/rigid_body.hpp"
#include "scene/components/transform.hpp"
#include "scene/physics_bridge.hpp"
#include "scene/scene_stack.hpp"

namespace plumb {

namespace {

constexpr float kSnap = 2.0f;          // px below the feet that still count as ground while walking
constexpr float kHeldDown = 0.5f;      // of an axis: as good as a key
constexpr int kDropTicks = 10;         // long enough to fall through a one-way platform
constexpr float kAirGround = 0.0625f;  // px below the feet that count as ground when none was there before

float approach(float value, float target, float step) {
    return value < target ? std::min(value + step, target) : std::max(value - step, target);
}

/// What the player wants in this tick.
struct Wishes {
    float x = 0.0f;  // -1..1
    bool down = false;
    bool jumpPressed = false;
    bool jumpHeld = false;
};

Wishes wishesOf(const Input& input) {
    const float x = input.getAxis(Axis::Horizontal);
    return {std::abs(x) < 0.1f ? 0.0f : x, input.getAxis(Axis::Vertical) > kHeldDown,
            input.isPressed(Action::Jump), input.isHeld(Action::Jump)};
}

/// One character in one tick: the chapters in order are in `run`.
class Character {
public:
    Character(World& world, EntityId entity, const Wishes& wishes, float dt)
        : world_{world},
          entity_{entity},
          wishes_{wishes},
          dt_{dt},
          player_{world.get<PlayerController>(entity)},
          body_{world.get<RigidBody>(entity)},
          transform_{world.get<Transform>(entity)},
          mover_{world, boxOf(world.get<BoxCollider>(entity), transform_), filterOf(world, entity),
                 cosine(player_.steepest)} {}

    void run() {
        const Vec2 start = mover_.box().min;
        countDown();
        ride();
        runAndBrake();
        fall();
        jump();
        move();
        transform_.position += mover_.box().min - start;
        body_.grounded = grounded_;
    }

private:
    static AABB boxOf(const BoxCollider& collider, const Transform& transform) {
        const Vec2 corner = transform.position + collider.offset;
        const Vec2 size{collider.width * std::abs(transform.scale.x),
                        collider.height * std::abs(transform.scale.y)};
        return {corner, corner + size};
    }
    static QueryFilter filterOf(World& world, EntityId entity) {
        const auto& collider = std::as_const(world).get<BoxCollider>(entity);
        QueryFilter filter;
        filter.layers = collider.layers;
        filter.mask = collider.mask;
        filter.except = entity;
        return filter;
    }

    void countDown() {
        for (int* ticks : {&player_.coyote, &player_.buffer, &player_.hold, &player_.dropping}) {
            *ticks = std::max(*ticks - 1, 0);
        }
        // One more than the ticks that follow: this one counts too.
        if (wishes_.jumpPressed) player_.buffer = player_.bufferTicks + 1;
        grounded_ = body_.grounded && body_.velocity.y >= 0.0f;
        if (grounded_) player_.coyote = player_.coyoteTicks + 1;
        mover_.filter().oneWay = player_.dropping == 0 && body_.velocity.y >= 0.0f;
    }

    /// Goes along with what it stands on, and out of what was moved into it.
    void ride() {
        player_.carry = {};
        if (grounded_ && world_.alive(player_.ground)) {
            const Vec2 way = tickMotionOf(world_, player_.ground, dt_);
            mover_.carry(way);
            player_.carry = way / dt_;
        }
        mover_.pushOut();
    }

    void runAndBrake() {
        const float control = grounded_ ? 1.0f : player_.airControl;
        const float target = wishes_.x * player_.runSpeed;
        float& speed = body_.velocity.x;
        const bool tooFast = std::abs(speed) > player_.runSpeed && speed * wishes_.x > 0.0f;
        const float rate = tooFast ? player_.overspeedBraking : player_.runAcceleration;
        speed = approach(speed, target, rate * control * dt_);
        if (wishes_.x != 0.0f) player_.facing = wishes_.x > 0.0f ? 1 : -1;
    }

    void fall() {
        if (grounded_) return;
        const float most = wishes_.down ? player_.fastFallSpeed : player_.fallSpeed;
        const bool apex = wishes_.jumpHeld && std::abs(body_.velocity.y) < player_.apexSpeed;
        const float gravity = player_.gravity * (apex ? 0.5f : 1.0f);
        body_.velocity.y = approach(body_.velocity.y, most, gravity * dt_);
        if (player_.hold == 0) return;
        if (wishes_.jumpHeld) {
            body_.velocity.y = std::min(body_.velocity.y, -player_.jumpSpeed);
        } else {
            player_.hold = 0;
        }
    }

    void jump() {
        if (player_.buffer == 0 || (!grounded_ && player_.coyote == 0)) return;
        if (grounded_ && wishes_.down && dropThrough()) return;
        player_.buffer = player_.coyote = 0;
        player_.hold = player_.jumpHoldTicks;
        // What it stood on gives its speed along, but never takes from the height.
        body_.velocity.x += wishes_.x * player_.jumpBoost + player_.carry.x;
        body_.velocity.y = -player_.jumpSpeed + std::min(player_.carry.y, 0.0f);
        leaveGround();
        playCue(world_, entity_, &SoundCues::jump);
    }

    /// Down and jump on one-way ground falls through it.
    bool dropThrough() {
        mover_.filter().oneWay = false;
        if (mover_.standsOn(kSnap)) {
            mover_.filter().oneWay = true;
            return false;
        }
        player_.buffer = player_.coyote = 0;
        player_.dropping = kDropTicks;
        leaveGround();
        return true;
    }

    void leaveGround() {
        grounded_ = false;
        player_.ground = {};
        player_.groundNormal = {0.0f, -1.0f};
        if (body_.velocity.y < 0.0f) mover_.filter().oneWay = false;
    }

    void move() {
        const bool walked = grounded_;
        const Vec2 way = body_.velocity * dt_;
        CharacterMotion motion;
        if (grounded_) {
            motion = mover_.walk(way.x, player_.groundNormal);
            const CharacterMotion ground = mover_.snapDown(std::abs(way.x) * 1.2f + kSnap);
            motion.landed = ground.landed;
            motion.ground = ground.ground;
            motion.groundNormal = ground.groundNormal;
        } else {
            motion = mover_.fly(way, player_.cornerCorrection);
            if (!motion.landed && body_.velocity.y >= 0.0f) {
                const CharacterMotion ground = mover_.snapDown(kAirGround);
                if (ground.landed) motion = ground;
            }
        }
        if (motion.hitWall) meetWall(motion.wall);
        if (motion.hitCeiling && body_.velocity.y < 0.0f) body_.velocity.y = 0.0f, player_.hold = 0;
        if (motion.landed) {
            land(motion, walked);
        } else if (walked) {
            body_.velocity += player_.carry;  // walked off: what it stood on gives its speed along
            body_.velocity.y = std::max(body_.velocity.y, 0.0f);
            leaveGround();
        }
    }

    void land(const CharacterMotion& motion, bool walked) {
        grounded_ = true;
        player_.ground = motion.ground;
        player_.groundNormal = motion.groundNormal;
        player_.hold = 0;
        body_.velocity.y = 0.0f;
        if (walked) return;
        body_.velocity.x -= tickMotionOf(world_, motion.ground, dt_).x / dt_;
        playCue(world_, entity_, &SoundCues::land);
    }

    /// Walls stop it; loose boxes give way.
    void meetWall(EntityId wall) {
        const bool loose =
            world_.alive(wall) && world_.has<RigidBody>(wall) && !world_.has<CharacterBody>(wall);
        if (!loose || !grounded_) {
            body_.velocity.x = 0.0f;
            return;
        }
        const float speed = std::clamp(body_.velocity.x, -player_.pushSpeed, player_.pushSpeed);
        body_.velocity.x = speed;
        world_.get<RigidBody>(wall).velocity.x = speed;
    }

    World& world_;
    EntityId entity_;
    Wishes wishes_;
    float dt_;
    PlayerController& player_;
    RigidBody& body_;
    Transform& transform_;
    CharacterMover mover_;
    bool grounded_ = false;
};

bool isDead(const World& world, EntityId entity) {
    const Respawn* respawn = world.find<Respawn>(entity);
    return respawn != nullptr && respawn->waiting > 0;
}

}  // namespace

void PlayerControllerSystem::update(World& world, float dt) {
    if (world.query<const PlayerController>().empty()) return;
    for (auto [entity, player] : world.query<const PlayerController>(with<RigidBody, BoxCollider, Transform>,
                                                                     without<CharacterBody>)) {
        entity.addComponent<CharacterBody>();
    }
    syncBodies(world, dt);
    for (auto [entity, player] :
         world.query<const PlayerController>(with<RigidBody, BoxCollider, Transform, CharacterBody>)) {
        if (isDead(world, entity)) continue;
        const Wishes wishes = wishesOf(inputFor(world, entity));
        Character{world, entity, wishes, dt}.run();
    }
}

}  // namespace plumb
