#include "gameplay/systems/player_controller_system.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ecs/world.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "gameplay/components/actors/respawn.hpp"
#include "gameplay/sound_cue.hpp"
#include "input/input.hpp"
#include "physics/character/character_mover.hpp"
#include "scene/components/bodies/character_body.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/transform.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/physics/physics_queries.hpp"
#include "scene/physics_bridge.hpp"
#include "scene/scene_stack.hpp"

namespace plumb {

namespace {

constexpr float kSnap = 2.0f;          // px, maximum distance to the ground while walking
constexpr float kHeldDown = 0.5f;      // axis value above which down counts as held
constexpr int kDropTicks = 10;         // ticks, enough to fall through a one-way platform
constexpr float kAirGround = 0.0625f;  // px, maximum distance to the ground for landing

float approach(float value, float target, float step) {
    return value < target ? std::min(value + step, target) : std::max(value - step, target);
}

/// Input of a character in this tick.
struct Wishes {
    float x = 0.0f;  // horizontal axis, -1..1
    bool down = false;
    bool jumpPressed = false;
    bool jumpHeld = false;
};

Wishes wishesOf(const Input& input) {
    const float x = input.getAxis(Axis::Horizontal);
    return {std::abs(x) < 0.1f ? 0.0f : x, input.getAxis(Axis::Vertical) > kHeldDown,
            input.isPressed(Action::Jump), input.isHeld(Action::Jump)};
}

/// Moves one character in one tick; run() is the sequence of steps. Velocities are in px/s, as in the
/// components; displacements and positions are in metres, as in the physics.
class Character {
public:
    Character(World& world, EntityId entity, const Wishes& wishes, float dt)
        : world_{world},
          physics_{world.resource<PhysicsState>()},
          entity_{entity},
          wishes_{wishes},
          dt_{dt},
          player_{world.get<PlayerController>(entity)},
          body_{world.get<RigidBody>(entity)},
          transform_{world.get<Transform>(entity)},
          definition_{definitionOf()},
          mover_{physics_.world, definition_, place(), dt} {}

    void run() {
        const physics::WorldPosition start = mover_.position();
        countDown();
        findGround();
        runAndBrake();
        fall();
        jump();
        move();
        if (!(mover_.position() == start))
            transform_.position += toPixels(mover_.position() - start, physics_.scale);
        body_.grounded = grounded_;
    }

private:
    using Touch = physics::CharacterTouch;
    using Motion = physics::CharacterMotion;

    [[nodiscard]] float metres(float pixels) const { return pixels * physics_.scale.metres; }
    [[nodiscard]] Vec2 metres(Vec2 pixels) const { return toMetres(pixels, physics_.scale); }

    [[nodiscard]] Vec2 sizeOf(const BoxCollider& collider) const {
        return {collider.width * std::abs(transform_.scale.x),
                collider.height * std::abs(transform_.scale.y)};
    }
    [[nodiscard]] physics::WorldPosition place() const {
        const auto& collider = std::as_const(world_).get<BoxCollider>(entity_);
        return positionInMetres(transform_.position + collider.offset + sizeOf(collider) * 0.5f,
                                physics_.scale);
    }
    [[nodiscard]] physics::CharacterDefinition definitionOf() const {
        const auto& collider = std::as_const(world_).get<BoxCollider>(entity_);
        physics::CharacterDefinition definition;
        definition.outline = physics::box(metres(sizeOf(collider) * 0.5f));
        definition.steepest = player_.steepest;
        definition.snap = metres(kSnap);
        definition.cornerCorrection = metres(player_.cornerCorrection) + 2.0f * definition.gap;
        definition.filter.layers = collider.layers;
        definition.filter.mask = collider.mask;
        definition.filter.except = bodyOf(std::as_const(physics_), entity_);
        return definition;
    }

    void countDown() {
        for (int* ticks : {&player_.coyote, &player_.buffer, &player_.hold, &player_.dropping}) {
            *ticks = std::max(*ticks - 1, 0);
        }
        // Add 1, as the current tick counts too.
        if (wishes_.jumpPressed) player_.buffer = player_.bufferTicks + 1;
        grounded_ = body_.grounded && body_.velocity.y >= 0.0f;
        if (grounded_) player_.coyote = player_.coyoteTicks + 1;
        mover_.probe().oneWay = player_.dropping == 0 && body_.velocity.y >= 0.0f;
    }

    /// Finds the ground body, and its displacement in this tick.
    void findGround() {
        player_.carry = {};
        if (!grounded_ || !world_.alive(player_.ground)) return;
        const Vec2 way = tickMotionOf(world_, player_.ground, dt_);
        player_.carry = way / dt_;
        ride_ = metres(way);
        ground_ = bodyOf(std::as_const(physics_), player_.ground);
        if (!ground_) return;
        for (std::uint32_t s = physics_.world.bodies.info[ground_.index].firstShape; s != physics::kNone;
             s = physics_.world.shapes.info[s].next) {
            const physics::ShapeInfo& shape = physics_.world.shapes.info[s];
            if ((shape.flags & physics::kOneWay) != 0) mover_.probe().floor = {s, shape.generation};
        }
    }

    /// Moves the character with the ground, and out of the path of moving bodies.
    /// @param own  m, its own displacement in this tick
    /// @return     m, the part of `own` that remains
    Vec2 ride(Vec2 own) {
        const auto pushes = mover_.probe().pushesAt(mover_.position(), ride_, own, ground_);
        mover_.probe().carrier = ground_;
        mover_.carry(ride_);
        mover_.probe().carrier = {};
        const Vec2 left = mover_.giveWay(pushes, grounded_ ? Vec2{} : own);
        mover_.pushOut();
        return left;
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
        // Add the velocity of the ground, but do not let it reduce the height of the jump.
        body_.velocity.x += wishes_.x * player_.jumpBoost + player_.carry.x;
        body_.velocity.y = -player_.jumpSpeed + std::min(player_.carry.y, 0.0f);
        leaveGround();
        playCue(world_, entity_, &SoundCues::jump);
    }

    /// Starts falling through the ground if it is one-way. @return false if it is not
    bool dropThrough() {
        mover_.probe().oneWay = false;
        if (mover_.standsOn(metres(kSnap))) {
            mover_.probe().oneWay = true;
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
        if (body_.velocity.y < 0.0f) mover_.probe().oneWay = false;
    }

    void move() {
        const bool walked = grounded_;
        const Vec2 way = metres(body_.velocity * dt_);
        const Vec2 left = ride(way);
        const Motion motion = grounded_ ? walk(way.x) : fly(left);
        if (motion.wall) meetWall(motion.wall);
        if (motion.slope) meetWall(motion.slope);
        if (motion.ceiling && body_.velocity.y < 0.0f) body_.velocity.y = 0.0f, player_.hold = 0;
        if (motion.ground) {
            land(motion.ground, walked);
        } else if (walked) {
            body_.velocity += player_.carry;  // walked off a ledge: keep the velocity of the ground
            body_.velocity.y = std::max(body_.velocity.y, 0.0f);
            leaveGround();
        }
    }

    Motion walk(float dx) {
        Motion motion = mover_.walk(dx, player_.groundNormal);
        motion.ground = mover_.snapDown(std::abs(dx) * 1.2f + metres(kSnap));
        return motion;
    }

    Motion fly(Vec2 way) {
        Motion motion = mover_.fly(way);
        if (!motion.ground && body_.velocity.y >= 0.0f) motion.ground = mover_.snapDown(metres(kAirGround));
        return motion;
    }

    void land(const Touch& ground, bool walked) {
        grounded_ = true;
        player_.ground = ownerOf(physics_, ground.body);
        player_.groundNormal = ground.normal;
        player_.hold = 0;
        body_.velocity.y = 0.0f;
        if (walked) return;
        body_.velocity.x -= tickMotionOf(world_, player_.ground, dt_).x / dt_;
        playCue(world_, entity_, &SoundCues::land);
    }

    /// Stops at walls; pushes dynamic bodies.
    void meetWall(const Touch& touch) {
        if (body_.velocity.x * touch.normal.x >= 0.0f) return;
        const EntityId wall = ownerOf(physics_, touch.body);
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
    PhysicsState& physics_;
    EntityId entity_;
    Wishes wishes_;
    float dt_;
    PlayerController& player_;
    RigidBody& body_;
    Transform& transform_;
    physics::CharacterDefinition definition_;
    physics::CharacterMover mover_;
    physics::BodyId ground_;  // body of the ground, if it exists
    Vec2 ride_;               // m, displacement of the ground in this tick
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
