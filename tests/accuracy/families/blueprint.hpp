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

struct BodyPlan {  ///< a body of a Blueprint with its shapes
    BodySetup setup;
    std::vector<ShapeSetup> shapes;
    std::vector<std::vector<Vec2>> loops;  ///< closed chain shapes; bodies touch their right side
    Material loopMaterial;                 ///< material of `loops`
    float mass = 0.0f;                     ///< mass, kg; 0: computed from the shapes
};

/// A condition that a scene must satisfy at its end.
struct Goal {
    std::string_view name;                      ///< predicate that must be true: "stands", "turns"
    std::function<double(const Stage&)> error;  ///< computes the error, in the unit of `bound`
    double bound = 0.0;                         ///< maximum error
};

/// Description of a scene as data. It can be built in any engine, moved, mirrored, scaled, built in another
/// order or without some of its bodies. Bodies and joints are identified by index. y points up.
struct Blueprint {
    Vec2 gravity{0.0f, -10.0f};  ///< m/s2
    double seconds = 10.0;       ///< simulated time, s
    std::vector<BodyPlan> bodies;
    std::vector<JointSetup> joints;
    /// Called before each step with the number of the step. May be empty.
    std::function<void(Stage&, int)> drive;
    /// Adds soft bodies or fields, which SceneBuilder does not support. Called once after all bodies are
    /// built. A scene with this function runs in Plumb only. May be empty.
    std::function<void(Stage&)> extra;
    std::string_view extraNeeds;  ///< feature used by `extra` that other engines lack: "soft bodies"
    std::vector<Goal> goals;
    /// True if no motor, kinematic body, field or edit adds energy.
    bool closed = true;
    /// Maximum number of bodies on top of each other. Each contact may be pushed apart by one slop of
    /// Settings, which lifts all bodies above it; the energy check allows for this energy.
    int layers = 1;

    std::uint32_t add(const BodyPlan& plan);  ///< all add functions return the index of the body
    std::uint32_t add(const BodySetup& setup, const Outline& outline, const Material& material = {});
    std::uint32_t addStatic(const Outline& outline, Vec2 position, const Material& material = {},
                            float angle = 0.0f);
    std::uint32_t addDynamic(const Outline& outline, Vec2 position, const Material& material = {},
                             float angle = 0.0f);
    std::uint32_t addFloor(const Material& material = {});  ///< floor 200 m wide, its top at y = 0
    std::uint32_t addAnchor(Vec2 position);                 ///< static body without a shape

    /// Connects two bodies at a point in world coordinates. `joint` contains all other properties.
    void join(std::uint32_t a, std::uint32_t b, Vec2 point, JointSetup joint = {});
};

inline scenes::BodyHandle handleOf(std::uint32_t body) { return {body}; }

}  // namespace plumb::families
