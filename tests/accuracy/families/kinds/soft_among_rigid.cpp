// Jellies, ropes and cloths in a pit, with crates and balls of 1/100 to 100 times their mass
// falling on them. Soft bodies are damped and the pit is closed, so all bodies come to rest,
// except balls, which have no rolling resistance, and heavy crates on a light rope between two
// pins, which swing for long. No body may pass through the floor, and no crate into a jelly
// whose particles are closer to each other than the crate is wide. Kinetic plus potential
// energy must not exceed the initial value, as springs store no energy at the start.

#include <algorithm>
#include <cmath>
#include <memory>

#include "physics/measure/measures.hpp"
#include "physics/soft/softbody.hpp"
#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

namespace {

constexpr float kDent = 0.02f;  // maximum penetration of a particle of 5 cm into the ground, m

struct SoftScene {
    float half = 3.0f;       // half the width of the pit, m
    std::uint32_t kind = 0;  // 0: jelly, 1: rope, 2: cloth
    float size = 1.0f;       // size of the soft body, m
    float mass = 1.0f;       // mass of the soft body, kg
    float softness = 0.0f;   // compliance, m/N
    float friction = 0.5f;
    float damping = 1.0f;  // 1/s
    bool pinned = false;
    int points = 12;
};

/// State of the soft body in one run.
struct SoftState {
    physics::SoftBodyId body;
    double start = 0.0;        ///< initial energy, J
    double highest = 0.0;      ///< maximum energy, J
    std::string refused;       ///< error message of the creation; empty: created
    std::vector<Vec2> before;  ///< positions of the particles 1 s before the end, m
};

physics::SoftMaterial materialOf(const SoftScene& scene, float scale) {
    physics::SoftMaterial material;
    // Forces are proportional to scale^3 and lengths to scale, so compliances to 1 / scale^2.
    const float give = 1.0f / (scale * scale);
    material.mass = scene.mass * scale * scale;
    material.radius = 0.05f * scale;
    material.stretchCompliance = 0.01f * scene.softness * give;
    material.bendCompliance = 1e-2f * give;
    material.areaCompliance = scene.softness * give;
    material.damping = scene.damping;
    material.friction = scene.friction;
    return material;
}

Result<physics::SoftBodyId> build(Stage& stage, const SoftScene& scene) {
    physics::World& world = *stage.world();
    const physics::SoftMaterial material = materialOf(scene, stage.scale());
    if (scene.kind == 0) {
        std::vector<Vec2> outline;
        for (int i = 0; i < scene.points; ++i) {
            const float angle = kTau * static_cast<float>(i) / static_cast<float>(scene.points);
            outline.push_back(stage.vectorOf(scene.size * Vec2{std::cos(angle), std::sin(angle)}));
        }
        return physics::createJelly(world, stage.placeOf({0.0f, scene.size + 0.1f}), outline, material);
    }
    if (scene.kind == 1)
        return physics::createRope(world, stage.placeOf({-scene.size, 2.0f}),
                                   stage.placeOf({scene.size, 2.0f}), scene.points, material);
    // Columns are along x and rows along y of the world, so a quarter turn swaps them.
    const bool turned = stage.variation().placement.quarterTurns % 2 != 0;
    const int columns = 6, rows = 3;
    return physics::createCloth(world, stage.placeOf({-scene.size, 2.0f}),
                                stage.vectorOf({2.0f * scene.size, -0.5f * scene.size}),
                                turned ? rows : columns, turned ? columns : rows, material);
}

/// Kinetic plus potential energy of rigid and soft bodies, J, in the blueprint's scale.
double energyOf(const Stage& stage) {
    const physics::World& world = *stage.world();
    const auto scale = static_cast<double>(stage.scale());
    double sum = physics::energyOf(world);
    for (const physics::SoftBody& soft : world.softBodies.all) {
        for (const physics::SoftParticle& particle : soft.particles) {
            const auto speed = static_cast<double>(length(particle.velocity));
            const auto gx = static_cast<double>(world.settings.gravity.x);
            const auto gy = static_cast<double>(world.settings.gravity.y);
            sum += static_cast<double>(particle.mass) *
                   (0.5 * speed * speed - gx * particle.place.x - gy * particle.place.y);
        }
    }
    return sum / (scale * scale * scale * scale);
}

std::vector<Vec2> pointsOf(const Stage& stage, physics::SoftBodyId body) {
    std::vector<Vec2> points;
    if (!physics::alive(*stage.world(), body)) return points;
    for (const physics::SoftParticle& particle : physics::particlesOf(*stage.world(), body))
        points.push_back(stage.pointOf(particle.place));
    return points;
}

/// True if a point is inside a polygon. Source: M. Shimrat,
/// "Algorithm 112: Position of point relative to polygon", 1962.
bool isInside(const std::vector<Vec2>& ring, Vec2 point) {
    bool inside = false;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const Vec2 a = ring[i], b = ring[j];
        if ((a.y > point.y) != (b.y > point.y) && point.x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x)
            inside = !inside;
    }
    return inside;
}

Vec2 at(const Stage& stage, std::uint32_t body) {
    const scenes::Point point = stage.positionOf(body);
    return {static_cast<float>(point.x), static_cast<float>(point.y)};
}

}  // namespace

Blueprint makeSoftAmongRigid(Random& random) {
    Blueprint plan;
    plan.closed = false;  // the common energy check does not include soft bodies; a goal below checks them
    constexpr int kSteps = 600;
    plan.seconds = kSteps * static_cast<double>(kStep);
    plan.extraNeeds = "soft bodies";
    SoftScene scene;
    scene.kind = random.below(3);
    scene.half = random.between(1.5f, 4.0f);
    scene.size = scene.half * random.between(0.3f, 0.7f);
    const float crate = random.between(0.1f, 0.4f), crateMass = random.between(0.5f, 5.0f);  // m, kg
    // The distance of a jelly's particles must be below the shorter side of a crate, 1.2 times its size.
    scene.size = std::min(scene.size, 40.0f * crate / kTau);
    scene.points = scene.kind == 0 ? std::max(static_cast<int>(kTau * scene.size / crate) + 1, 8)
                                   : 6 + static_cast<int>(random.below(10));
    scene.softness = random.below(3) == 0 ? 0.0f : 1e-5f * std::pow(100.0f, random.unit());
    scene.friction = random.between(0.1f, 0.9f);
    scene.damping = random.between(0.5f, 2.0f);
    scene.pinned = random.below(2) == 0;
    const float ratio = 0.01f * std::pow(10000.0f, random.unit());
    scene.mass = crateMass * ratio;
    const Material stuff{.friction = scene.friction};
    plan.addStatic(scenes::box({scene.half + 1.0f, 0.5f}), {0.0f, -0.5f}, stuff);
    for (const float side : {-1.0f, 1.0f})
        plan.addStatic(scenes::box({0.5f, 8.0f}), {side * (scene.half + 0.5f), 8.0f}, stuff);
    std::vector<std::uint32_t> crates, boxes;
    const int count = 1 + static_cast<int>(random.below(8));
    for (int i = 0; i < count; ++i) {
        BodyPlan item;
        item.setup.position = {random.between(-0.7f, 0.7f) * (scene.half - crate),
                               2.0f * scene.size + 2.2f + 2.1f * crate * static_cast<float>(i)};
        item.mass = crateMass;
        const bool round = random.below(2) == 0;
        item.shapes.push_back(
            {round ? scenes::circle(crate) : scenes::box({0.8f * crate, 0.6f * crate}), stuff});
        crates.push_back(plan.add(item));
        if (!round) boxes.push_back(crates.back());
    }

    auto state = std::make_shared<SoftState>();
    plan.extra = [=](Stage& stage) {
        *state = {};
        const Result<physics::SoftBodyId> made = build(stage, scene);
        if (!made) {
            state->refused = made.error().text();
            return;
        }
        state->body = *made;
        if (scene.kind == 0 || !scene.pinned) return;
        const int last = static_cast<int>(physics::particlesOf(*stage.world(), *made).size()) - 1;
        static_cast<void>(physics::pinParticle(*stage.world(), *made, 0, true));
        static_cast<void>(physics::pinParticle(*stage.world(), *made, last, true));
    };
    plan.drive = [=](Stage& stage, int step) {
        if (stage.world() == nullptr) return;
        const double energy = energyOf(stage);
        if (step == 0) state->start = state->highest = energy;
        state->highest = std::max(state->highest, energy);
        if (step == kSteps - 60) state->before = pointsOf(stage, state->body);
    };
    plan.goals.push_back({"is built", [=](const Stage&) { return state->refused.empty() ? 0.0 : 1.0; }, 0.0});
    if (scene.kind == 0 || !scene.pinned) {
        // A jelly may continue to roll slowly under a box on its top.
        plan.goals.push_back(rests(boxes, scene.kind == 0 ? 0.5 : 0.2));
    }
    if (scene.kind == 0 && boxes.size() == crates.size()) {
        plan.goals.push_back({"the jelly rests",
                              [=](const Stage& stage) {
                                  const std::vector<Vec2> points = pointsOf(stage, state->body);
                                  double furthest = 0.0;
                                  for (std::size_t i = 0; i < std::min(points.size(), state->before.size());
                                       ++i) {
                                      const float moved = length(points[i] - state->before[i]);
                                      furthest = std::max(furthest, static_cast<double>(moved));
                                  }
                                  return furthest;
                              },
                              0.1});  // maximum displacement in the last second, m
    }
    plan.goals.push_back(staysIn(crates, {-scene.half, 0.0f}, {scene.half, 20.0f}));
    plan.goals.push_back({"the soft body stays in the pit",
                          [=](const Stage& stage) {
                              double outside = 0.0;
                              for (const Vec2 point : pointsOf(stage, state->body))
                                  outside +=
                                      point.y > -kDent && std::fabs(point.x) < scene.half + kDent ? 0.0 : 1.0;
                              return outside;
                          },
                          0.0});
    if (scene.kind == 0)
        plan.goals.push_back({"no crate is inside the jelly",
                              [=](const Stage& stage) {
                                  const std::vector<Vec2> ring = pointsOf(stage, state->body);
                                  double inside = 0.0;
                                  for (const std::uint32_t body : crates)
                                      inside += !ring.empty() && isInside(ring, at(stage, body)) ? 1.0 : 0.0;
                                  return inside;
                              },
                              0.0});
    plan.goals.push_back({"gains no energy",
                          [=](const Stage&) {
                              return (state->highest - state->start) /
                                     std::max(std::fabs(state->start), 1e-3);
                          },
                          0.01});
    plan.goals.push_back(overlapsAtMost(0.05));
    return plan;
}

}  // namespace plumb::families
