#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "tests/bench/physics/scene_builder.hpp"

namespace plumb::families {

using scenes::BodySetup;
using scenes::JointSetup;
using scenes::Material;
using scenes::Motion;
using scenes::Outline;

class Stage;

struct ShapeSetup {
    Outline outline;
    Material material;
};

struct BodyPlan {
    BodySetup setup;
    std::vector<ShapeSetup> shapes;
    std::vector<std::vector<Vec2>> loops;  ///< closed chains, free on the right of their direction
    Material loopMaterial;
    float mass = 0.0f;  ///< kg, replaces the mass of its shapes; 0: that of its shapes
};

/// A condition that a scene should satisfy at its end.
struct Goal {
    std::string_view name;                      ///< a verb: "stands", "turns"
    std::function<double(const Stage&)> error;  ///< in the unit of the bound
    double bound = 0.0;                         ///< maximum error
};

/// A scene as data, so that it can be built in any engine, moved, mirrored, scaled, built in another
/// order or without some of its bodies. Bodies and joints are identified by index. y points up.
struct Blueprint {
    Vec2 gravity{0.0f, -10.0f};  ///< m/s2
    double seconds = 10.0;       ///< of simulated time
    std::vector<BodyPlan> bodies;
    std::vector<JointSetup> joints;
    /// Called before each step with its number. May be empty.
    std::function<void(Stage&, int)> drive;
    /// Adds what a SceneBuilder does not support: soft bodies, fields. Called once after all bodies are
    /// built, only in this repository's engine; a scene that has it is not run in others. May be empty.
    std::function<void(Stage&)> extra;
    std::string_view extraNeeds;  ///< feature that others lack: "soft bodies"
    std::vector<Goal> goals;
    /// No motor, kinematic body, field or edit adds energy.
    bool closed = true;
    /// Maximum number of bodies on top of each other. Each may be pushed out of
    /// an overlap of one slop, and with it all above: energy that is allowed for.
    int layers = 1;

    std::uint32_t add(const BodyPlan& plan);
    std::uint32_t add(const BodySetup& setup, const Outline& outline, const Material& material = {});
    std::uint32_t addStatic(const Outline& outline, Vec2 position, const Material& material = {},
                            float angle = 0.0f);
    std::uint32_t addDynamic(const Outline& outline, Vec2 position, const Material& material = {},
                             float angle = 0.0f);
    std::uint32_t addFloor(const Material& material = {});  ///< 200 m wide, its top at y = 0
    std::uint32_t addAnchor(Vec2 position);                 ///< static, without a shape

    /// Connects two bodies at a point of the world. `joint` has the other properties.
    void join(std::uint32_t a, std::uint32_t b, Vec2 point, JointSetup joint = {});
};

inline scenes::BodyHandle handleOf(std::uint32_t body) { return {body}; }

}  // namespace plumb::families
