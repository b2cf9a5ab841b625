#pragma once

#include <cstdint>
#include <vector>

#include "editor/model/document/object_id.hpp"
#include "physics/model/bodies.hpp"
#include "physics/world.hpp"
#include "scene/physics/physics_units.hpp"

namespace plumb::editor {

/// Changes that the game made to one body between two physics steps.
struct BodyInput {
    /// Placed: new pose. Pushed: new velocity. Driven: new acceleration, force, torque, drag or gravity
    /// scale. DropsThrough: new value of `dropsThrough`. Gone: the game destroyed the body.
    enum Change : std::uint8_t { Placed = 1, Pushed = 2, Driven = 4, DropsThrough = 8, Gone = 16 };

    physics::BodyId body;
    std::uint8_t changed = 0;  ///< bits of Change
    physics::BodyPose pose;
    physics::BodyMotion motion;
    physics::BodyDrive drive;
    bool hasTarget = false;     ///< kinematic body moved to a target: the velocity is valid for one step
    bool dropsThrough = false;  ///< one-way shapes do not stop the body
};

/// Changes that the game made to one joint between two physics steps.
struct JointInput {
    physics::JointId joint;
    bool gone = false;              ///< the game destroyed the joint
    float motorSpeed = 0.0f;        ///< rad/s or m/s
    physics::WorldPosition target;  ///< m, of a mouse joint
};

/// Changes that the game made to one force field between two physics steps.
struct FieldInput {
    physics::FieldId field;
    bool gone = false;  ///< the game destroyed the field
    bool made = false;  ///< the game created the field
    physics::FieldDefinition definition;
};

/// All changes that the game made to its physics before one step.
struct TickInput {
    std::vector<BodyInput> bodies;
    std::vector<JointInput> joints;
    std::vector<FieldInput> fields;
    Vec2 gravity;  ///< m/s2
};

/// A dynamic body, and what was recorded of its motion.
struct WatchedBody {
    physics::BodyId body;
    ObjectId object;          ///< null: the body belongs to no entity of the scene
    float topSpeed = 0.0f;    ///< maximum speed, m/s
    int restTicks = 0;        ///< number of ticks at rest up to the end of the recording
    float reach = 0.0f;       ///< maximum distance of the body's points from its center of mass, m
    bool isBullet = false;    ///< RigidBody::bullet
    float sleepSpeed = 0.0f;  ///< speed below which the body is at rest, m/s
};

/// Recording of some seconds of a game's physics: initial worlds, and the changes by the game in each tick.
/// The same ticks can then be stepped again with other settings, without the game and in any thread.
struct PhysicsTape {
    struct Start {
        std::size_t tick = 0;  ///< index in `ticks` of the first tick after `world`
        physics::World world;  ///< state from which the ticks can be stepped
    };

    PixelScale scale;
    std::vector<Start> starts;  ///< initial worlds, earliest first
    std::vector<TickInput> ticks;
    std::vector<WatchedBody> watched;
    std::uint32_t leftOut = 0;   ///< bodies and joints created while recording, which are not recorded
    std::uint64_t contacts = 0;  ///< awake contacts, summed over the ticks
    std::uint64_t stays = 0;     ///< contact events of phase Stayed, summed over the ticks
};

/// Applies the recorded changes of a tick to a world. Skips bodies, joints and fields that the world lacks.
/// @param part  index of the step in a tick of several steps. Forces and targets of kinematic bodies are
///              applied for every step, all other changes only for the first
void applyInput(physics::World& world, const TickInput& input, int part = 0);

/// Records a tape while a copy of the game plays.
class TapeRecorder {
public:
    /// Starts a recording. @param world  state before the first tick
    void begin(const physics::World& world, PixelScale scale);
    /// Adds a copy of the world to `tape.starts`. Must be called between two ticks.
    void keepStart(const physics::World& world);
    /// Records the game's changes. Must be called right before the physics step.
    void beforeStep(const physics::World& world);
    void afterTick(const physics::World& world);

    bool on = false;  ///< a recording is in progress
    PhysicsTape tape;

private:
    void takeBodies(const physics::World& world, TickInput& input);
    void takeJoints(const physics::World& world, TickInput& input);
    void takeFields(const physics::World& world, TickInput& input);
    void remember(const physics::World& world);

    // State after the previous tick.
    physics::Bodies bodies_;
    physics::Joints joints_;
    physics::Slots<physics::Field> fields_;
};

}  // namespace plumb::editor
