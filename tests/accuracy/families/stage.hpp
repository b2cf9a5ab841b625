#pragma once

#include <memory>
#include <vector>

#include "math/rot.hpp"
#include "tests/accuracy/families/blueprint.hpp"
#include "tests/accuracy/families/variation.hpp"
#include "tests/bench/physics/overlap.hpp"
#include "tests/bench/physics/plumb_world.hpp"

namespace plumb::families {

inline constexpr float kStep = 1.0f / 60.0f;  ///< s

/// A scene while it runs. Bodies are those of the blueprint and all positions, angles and speeds are as it
/// has them, whatever the placement.
class Stage {
public:
    Stage(const Blueprint& plan, const Variation& variation);

    void step();  ///< drives the scene, and simulates one step of it
    [[nodiscard]] int steps() const { return steps_; }
    [[nodiscard]] double time() const { return steps_ * static_cast<double>(kStep); }

    [[nodiscard]] const Blueprint& plan() const { return plan_; }
    [[nodiscard]] const Variation& variation() const { return variation_; }
    /// False for a body that was dropped from the scene or destroyed since.
    [[nodiscard]] bool has(std::uint32_t body) const;
    [[nodiscard]] scenes::Point positionOf(std::uint32_t body) const;  ///< m
    [[nodiscard]] Rot rotationOf(std::uint32_t body) const;
    [[nodiscard]] Vec2 velocityOf(std::uint32_t body) const;  ///< m/s
    [[nodiscard]] float spinOf(std::uint32_t body) const;     ///< rad/s
    [[nodiscard]] Vec2 startOf(std::uint32_t body) const { return plan_.bodies[body].setup.position; }
    /// m: how far a body is from where it was planned.
    [[nodiscard]] double displacementOf(std::uint32_t body) const;
    /// rad: how far it turned from its planned angle, -pi to pi.
    [[nodiscard]] double turnOf(std::uint32_t body) const;

    void setVelocity(std::uint32_t body, Vec2 velocity);
    void setSpin(std::uint32_t body, float spin);
    void moveTo(std::uint32_t body, Vec2 position, float angle);  ///< kinematic: at the end of the step
    void setMass(std::uint32_t body, float kilograms);
    /// Puts a body elsewhere at once.
    void teleport(std::uint32_t body, Vec2 position, float angle);
    /// Whether that was done in the step before.
    [[nodiscard]] bool wasTeleported(std::uint32_t body) const;
    void destroy(std::uint32_t body);
    std::uint32_t spawn(const BodyPlan& plan);  ///< @return its index, after those of the blueprint

    [[nodiscard]] scenes::SceneBuilder& scene() { return *scene_; }
    [[nodiscard]] const scenes::SceneBuilder& scene() const { return *scene_; }
    /// The world of Plumb; null in other engines.
    [[nodiscard]] physics::World* world() { return plumb_ == nullptr ? nullptr : &plumb_->world(); }
    [[nodiscard]] const physics::World* world() const {
        return plumb_ == nullptr ? nullptr : &std::as_const(*plumb_).world();
    }
    /// m/s: by which the hits of a fast body within the last step changed its velocity, all together and
    /// along their normals. 0 in other engines. @pre has(body)
    [[nodiscard]] double hitSpeedOf(std::uint32_t body) const;
    /// False in other engines. @pre has(body)
    [[nodiscard]] bool isAsleep(std::uint32_t body) const;

    // For what Blueprint::extra adds to the world of Plumb: from the blueprint to the world and back.

    [[nodiscard]] physics::WorldPosition placeOf(Vec2 point) const;
    [[nodiscard]] Vec2 pointOf(physics::WorldPosition place) const;
    [[nodiscard]] Vec2 vectorOf(Vec2 vector) const { return scale_ * placed(vector); }
    [[nodiscard]] float scale() const { return scale_; }

    /// Where a body is in the engine; @pre has(body)
    [[nodiscard]] scenes::BodyHandle handleAt(std::uint32_t body) const { return handles_[body]; }
    [[nodiscard]] std::size_t size() const { return handles_.size(); }  ///< bodies, those gone too

private:
    void open();
    void build();
    void make(std::uint32_t body, const BodyPlan& plan);
    void make(const JointSetup& joint);
    [[nodiscard]] Vec2 placed(Vec2 direction) const;  ///< turned and mirrored, not scaled
    [[nodiscard]] Vec2 unplaced(Vec2 direction) const;
    [[nodiscard]] Vec2 local(Vec2 point) const;  ///< of a body's frame: mirrored and scaled
    [[nodiscard]] float placedAngle(float angle) const;
    [[nodiscard]] Outline placed(const Outline& outline) const;
    [[nodiscard]] Material placed(Material material) const;
    [[nodiscard]] float sign() const { return variation_.placement.mirrored ? -1.0f : 1.0f; }

    const Blueprint& plan_;
    Variation variation_;
    std::unique_ptr<scenes::SceneBuilder> scene_;
    scenes::PlumbWorld* plumb_ = nullptr;
    std::vector<scenes::BodyHandle> handles_;  ///< by body of the blueprint
    std::vector<std::uint32_t> teleported_;    ///< in this step
    Rot turn_;
    float scale_ = 1.0f;
    int steps_ = 0;
};

}  // namespace plumb::families
