#pragma once

#include <memory>
#include <vector>

#include "math/rot.hpp"
#include "tests/accuracy/families/blueprint.hpp"
#include "tests/accuracy/families/variation.hpp"
#include "tests/bench/physics/overlap.hpp"
#include "tests/bench/physics/plumb_world.hpp"

namespace plumb::families {

inline constexpr float kStep = 1.0f / 60.0f;  ///< time step, s

/// A running scene. Bodies have the indices of the blueprint; positions, angles and speeds are in the
/// blueprint's coordinates and scale, independent of the placement.
class Stage {
public:
    Stage(const Blueprint& plan, const Variation& variation);

    void step();                                        ///< calls Blueprint::drive and simulates one step
    [[nodiscard]] int steps() const { return steps_; }  ///< number of simulated steps
    [[nodiscard]] double time() const { return steps_ * static_cast<double>(kStep); }  ///< s

    [[nodiscard]] const Blueprint& plan() const { return plan_; }
    [[nodiscard]] const Variation& variation() const { return variation_; }
    /// False for a body that was omitted (Variation::dropped) or has been destroyed.
    [[nodiscard]] bool has(std::uint32_t body) const;
    [[nodiscard]] scenes::Point positionOf(std::uint32_t body) const;  ///< m
    [[nodiscard]] Rot rotationOf(std::uint32_t body) const;
    [[nodiscard]] Vec2 velocityOf(std::uint32_t body) const;  ///< m/s
    [[nodiscard]] float spinOf(std::uint32_t body) const;     ///< rad/s
    [[nodiscard]] Vec2 startOf(std::uint32_t body) const { return plan_.bodies[body].setup.position; }
    /// Distance of a body from its planned position, m.
    [[nodiscard]] double displacementOf(std::uint32_t body) const;
    /// Rotation of a body relative to its planned angle, rad, -pi to pi.
    [[nodiscard]] double turnOf(std::uint32_t body) const;

    void setVelocity(std::uint32_t body, Vec2 velocity);
    void setSpin(std::uint32_t body, float spin);
    /// Moves a kinematic body so that it reaches a pose at the end of the step.
    void moveTo(std::uint32_t body, Vec2 position, float angle);
    void setMass(std::uint32_t body, float kilograms);
    /// Moves a body to a pose at once.
    void teleport(std::uint32_t body, Vec2 position, float angle);
    /// True if teleport() was called for the body in the previous step.
    [[nodiscard]] bool wasTeleported(std::uint32_t body) const;
    void destroy(std::uint32_t body);
    /// Adds a body. @return its index, after those of the blueprint
    std::uint32_t spawn(const BodyPlan& plan);

    [[nodiscard]] scenes::SceneBuilder& scene() { return *scene_; }
    [[nodiscard]] const scenes::SceneBuilder& scene() const { return *scene_; }
    /// The world of Plumb; null in other engines.
    [[nodiscard]] physics::World* world() { return plumb_ == nullptr ? nullptr : &plumb_->world(); }
    [[nodiscard]] const physics::World* world() const {
        return plumb_ == nullptr ? nullptr : &std::as_const(*plumb_).world();
    }
    /// Sum of a body's normal velocity changes by impacts that continuous
    /// collision detection found within the last step, m/s; 0 in other engines.
    /// @pre has(body)
    [[nodiscard]] double hitSpeedOf(std::uint32_t body) const;
    /// True if a body sleeps; false in other engines. @pre has(body)
    [[nodiscard]] bool isAsleep(std::uint32_t body) const;

    // Conversions between blueprint and world coordinates, for use in Blueprint::extra.

    [[nodiscard]] physics::WorldPosition placeOf(Vec2 point) const;
    [[nodiscard]] Vec2 pointOf(physics::WorldPosition place) const;
    [[nodiscard]] Vec2 vectorOf(Vec2 vector) const { return scale_ * placed(vector); }
    [[nodiscard]] float scale() const { return scale_; }

    /// The engine's handle of a body. @pre has(body)
    [[nodiscard]] scenes::BodyHandle handleAt(std::uint32_t body) const { return handles_[body]; }
    [[nodiscard]] std::size_t size() const {
        return handles_.size();
    }  ///< number of bodies, including destroyed ones

private:
    void open();
    void build();
    void make(std::uint32_t body, const BodyPlan& plan);
    void make(const JointSetup& joint);
    [[nodiscard]] Vec2 placed(Vec2 direction) const;    ///< rotates and mirrors, does not scale
    [[nodiscard]] Vec2 unplaced(Vec2 direction) const;  ///< inverse of placed()
    [[nodiscard]] Vec2 local(Vec2 point) const;         ///< mirrors and scales a point of a body's frame
    [[nodiscard]] float placedAngle(float angle) const;
    [[nodiscard]] Outline placed(const Outline& outline) const;
    [[nodiscard]] Material placed(Material material) const;
    [[nodiscard]] float sign() const { return variation_.placement.mirrored ? -1.0f : 1.0f; }

    const Blueprint& plan_;
    Variation variation_;
    std::unique_ptr<scenes::SceneBuilder> scene_;
    scenes::PlumbWorld* plumb_ = nullptr;
    std::vector<scenes::BodyHandle> handles_;  ///< handle of each body of the blueprint
    std::vector<std::uint32_t> teleported_;    ///< bodies teleported in this step
    Rot turn_;                                 ///< rotation by Placement::quarterTurns
    float scale_ = 1.0f;                       ///< Placement::scale
    int steps_ = 0;
};

}  // namespace plumb::families
