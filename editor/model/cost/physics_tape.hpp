#pragma once

#include <cstdint>
#include <vector>

#include "editor/model/document/object_id.hpp"
#include "physics/model/bodies.hpp"
#include "physics/world.hpp"
#include "scene/physics/physics_units.hpp"

namespace plumb::editor {

/// What the game did to one body between two steps of the physics.
struct BodyInput {
    enum Change : std::uint8_t { Placed = 1, Pushed = 2, Driven = 4, DropsThrough = 8, Gone = 16 };

    physics::BodyId body;
    std::uint8_t changed = 0;  ///< bits of Change
    physics::BodyPose pose;
    physics::BodyMotion motion;
    physics::BodyDrive drive;
    bool hasTarget = false;  ///< kinematic: the velocity holds for one step
    bool dropsThrough = false;
};

struct JointInput {
    physics::JointId joint;
    bool gone = false;
    float motorSpeed = 0.0f;        ///< rad/s or m/s
    physics::WorldPosition target;  ///< m
};

struct FieldInput {
    physics::FieldId field;
    bool gone = false;
    bool made = false;
    physics::FieldDefinition definition;
};

/// All that a game did to its physics before one step.
struct TickInput {
    std::vector<BodyInput> bodies;
    std::vector<JointInput> joints;
    std::vector<FieldInput> fields;
    Vec2 gravity;  ///< m/s2
};

/// What a body that can be pushed did while it was watched.
struct WatchedBody {
    physics::BodyId body;
    ObjectId object;          ///< none: it is no entity of the scene
    float topSpeed = 0.0f;    ///< m/s
    int restTicks = 0;        ///< at the end: since when it has hardly moved
    float reach = 0.0f;       ///< m: no point of it is further from its centre of mass
    bool isBullet = false;    ///< RigidBody::bullet
    float sleepSpeed = 0.0f;  ///< m/s
};

/// Some seconds of a game's physics: worlds to begin with, and what the game did to them in each tick. The
/// same ticks can then be stepped again in other ways, without the game and in any thread.
struct PhysicsTape {
    struct Start {
        std::size_t tick = 0;  ///< of `ticks`: the first that follows
        physics::World world;
    };

    PixelScale scale;
    std::vector<Start> starts;  ///< the one of the longest way first
    std::vector<TickInput> ticks;
    std::vector<WatchedBody> watched;
    std::uint32_t leftOut = 0;   ///< bodies and joints that were made meanwhile: no part of it
    std::uint64_t contacts = 0;  ///< awake ones, summed over the ticks
    std::uint64_t stays = 0;     ///< events of contacts that go on, summed over the ticks
};

/// Does to a world what the game did to the recorded one. What that world does not have is left out.
/// @param part  of the tick, from 0 on: forces and ways of kinematic bodies hold for all of it, the rest is
///              done before the first one
void applyInput(physics::World& world, const TickInput& input, int part = 0);

/// Fills a tape while a copy of the game plays.
class TapeRecorder {
public:
    /// @param world  as the ticks will begin
    void begin(const physics::World& world, PixelScale scale);
    /// Keeps the world as one to begin with. To be called between two ticks.
    void keepStart(const physics::World& world);
    /// The game did what it wants to, and the step follows.
    void beforeStep(const physics::World& world);
    void afterTick(const physics::World& world);

    bool on = false;
    PhysicsTape tape;

private:
    void takeBodies(const physics::World& world, TickInput& input);
    void takeJoints(const physics::World& world, TickInput& input);
    void takeFields(const physics::World& world, TickInput& input);
    void remember(const physics::World& world);

    // After the tick before.
    physics::Bodies bodies_;
    physics::Joints joints_;
    physics::Slots<physics::Field> fields_;
};

}  // namespace plumb::editor
