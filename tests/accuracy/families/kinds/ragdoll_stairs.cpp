// Ragdolls that fall on stairs with a spin, and come to rest there or on the floor below.
//
// Hinges have friction and limits, and restitution is 0: swinging limbs lose
// their energy in a second or two, and friction holds bodies on the level
// steps. Joint errors may be up to 2 cm, which is visible at a figure of 1 m.

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

namespace {

/// A bone of a figure 1.7 m tall with hanging arms.
struct Bone {
    std::size_t parent;
    float y;          ///< height of its center above the feet, m
    Vec2 half;        ///< half extents, m; the head is a circle of radius half.x
    float pivot;      ///< height of the hinge to the parent above the feet, m
    float low, high;  ///< limits of the hinge, rad
};

constexpr std::array kBones{
    Bone{0, 1.15f, {0.12f, 0.28f}, 0.0f, 0.0f, 0.0f},     // torso
    Bone{0, 1.57f, {0.12f, 0.12f}, 1.44f, -0.5f, 0.5f},   // head
    Bone{0, 1.23f, {0.05f, 0.16f}, 1.38f, -2.5f, 2.5f},   // upper arms
    Bone{0, 1.23f, {0.05f, 0.16f}, 1.38f, -2.5f, 2.5f},   //
    Bone{2, 0.93f, {0.04f, 0.15f}, 1.08f, 0.0f, 2.4f},    // lower arms
    Bone{3, 0.93f, {0.04f, 0.15f}, 1.08f, 0.0f, 2.4f},    //
    Bone{0, 0.67f, {0.075f, 0.21f}, 0.87f, -0.5f, 1.8f},  // upper legs
    Bone{0, 0.67f, {0.075f, 0.21f}, 0.87f, -0.5f, 1.8f},  //
    Bone{6, 0.25f, {0.06f, 0.22f}, 0.46f, -2.2f, 0.0f},   // lower legs
    Bone{7, 0.25f, {0.06f, 0.22f}, 0.46f, -2.2f, 0.0f},   //
};
constexpr std::size_t kHead = 1;

struct Fall {
    Vec2 at;  ///< initial position of the torso, m
    float angle = 0.0f;
    Vec2 velocity;
    float spin = 0.0f;
};

void addFigure(Blueprint& plan, float size, const Fall& fall, Material skin, float torque,
               std::vector<std::uint32_t>& bodies) {
    const Rot rotation = rotFromAngle(fall.angle);
    const auto placed = [&](float y) { return fall.at + size * rotate(rotation, {0.0f, y - kBones[0].y}); };
    const auto first = static_cast<std::uint32_t>(plan.bodies.size());
    for (std::size_t i = 0; i < kBones.size(); ++i) {
        const Bone& bone = kBones[i];
        BodySetup setup{.position = placed(bone.y), .angle = fall.angle, .spin = fall.spin};
        setup.velocity = fall.velocity + cross(fall.spin, setup.position - fall.at);
        bodies.push_back(plan.add(
            setup, i == kHead ? scenes::circle(size * bone.half.x) : scenes::box(size * bone.half), skin));
        if (i == 0) continue;
        plan.join(
            first + static_cast<std::uint32_t>(bone.parent), bodies.back(), placed(bone.pivot),
            {.limited = true, .lower = bone.low, .upper = bone.high, .driven = true, .maxForce = torque});
    }
}

}  // namespace

Blueprint makeRagdollStairs(Random& random) {
    Blueprint plan;
    plan.seconds = 12.0;
    plan.closed = true;
    const int steps = 5 + static_cast<int>(random.below(8));
    const float run = random.between(0.2f, 0.7f), rise = run * random.between(0.3f, 1.0f);
    const float size = random.between(0.6f, 1.4f), density = random.between(1.0f, 100.0f);
    const float friction = random.between(0.3f, 0.9f);
    const Material stone{.friction = friction};
    plan.addFloor(stone);
    const auto top = [steps, rise](int step) { return rise * static_cast<float>(steps - step); };
    plan.addStatic(scenes::box({20.0f, 0.5f * top(0)}), {-20.0f, 0.5f * top(0)}, stone);
    for (int i = 1; i < steps; ++i)
        plan.addStatic(scenes::box({0.5f * run, 0.5f * top(i)}),
                       {run * (static_cast<float>(i) - 0.5f), 0.5f * top(i)}, stone);

    const int figures = 1 + static_cast<int>(random.below(3));
    // Hinge friction of up to 1/20 of mass * gravity * size.
    const float mass = density * size * size * 0.5f,
                torque = mass * 10.0f * size * random.between(0.005f, 0.05f);
    std::vector<std::uint32_t> bodies;
    for (int i = 0; i < figures; ++i) {
        Fall fall{.angle = random.between(-kPi, kPi),
                  .velocity = {random.between(-1.0f, 4.0f), random.between(-2.0f, 2.0f)},
                  .spin = random.between(-10.0f, 10.0f)};
        // The feet are up to 1.2 sizes away from the torso.
        fall.at = {run * random.between(0.0f, static_cast<float>(steps)),
                   top(0) + size * (1.3f + 2.5f * static_cast<float>(i)) + random.between(0.0f, 1.0f)};
        addFigure(plan, size, fall, {.density = density, .friction = friction, .group = -1 - i}, torque,
                  bodies);
    }
    plan.goals.push_back(keepsJoints(0.02 * static_cast<double>(size)));
    plan.goals.push_back(rests(bodies, 0.05));
    plan.goals.push_back({"stays above the stairs",
                          [=](const Stage& stage) {
                              double inside = 0.0;
                              for (const std::uint32_t body : bodies) {
                                  if (!stage.has(body)) continue;
                                  const scenes::Point at = stage.positionOf(body);
                                  const double step = std::ceil(at.x / static_cast<double>(run));
                                  const double ground = top(
                                      static_cast<int>(std::clamp(step, 0.0, static_cast<double>(steps))));
                                  inside += at.y < ground ? 1.0 : 0.0;
                              }
                              return inside;
                          },
                          0.0});
    plan.goals.push_back(overlapsAtMost(0.02));
    return plan;
}

}  // namespace plumb::families
