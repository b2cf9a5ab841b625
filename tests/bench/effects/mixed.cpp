#include <cstdio>
#include <vector>

#include "math/portable.hpp"
#include "math/rot.hpp"
#include "physics/soft/softbody.hpp"
#include "tests/bench/callgrind.hpp"
#include "tests/bench/effects/effects_bench.hpp"

namespace {

// The function that callgrind measures.
extern "C" __attribute__((noinline)) void plumbMixedSteps(plumb::physics::World* world, int steps) {
    for (int i = 0; i < steps; ++i) plumb::physics::step(*world, plumb::bench::kTick);
}

}  // namespace

namespace plumb::bench {

namespace {

using namespace physics;

constexpr int kMixedCrates = 500;
constexpr double kCratesShare = 1.1;  // target: cost of the crates beside others / cost alone

void addFloor(World& world) {
    world.settings.gravity = {0.0f, -10.0f};
    world.settings.sleeping = false;
    const BodyId ground = *createBody(world, {.kind = BodyKind::Static, .position = {0.0, -1.0}});
    static_cast<void>(createShape(world, ground, box({200.0f, 1.0f})));
}

/// Adds crates that cannot rotate, in stacks of five.
void addCrates(World& world) {
    for (int i = 0; i < kMixedCrates; ++i) {
        BodyDefinition body;
        body.position = {-100.0 + 1.2 * (i / 5), 0.5 + i % 5};
        body.fixedRotation = true;
        static_cast<void>(createShape(world, *createBody(world, body), box({0.5f, 0.5f})));
    }
}

/// Adds a ragdoll of ten capsules and nine hinges with limits, and a jelly.
void addOthers(World& world) {
    struct Limb {
        int parent;
        Vec2 from, to;
    };
    constexpr Limb kLimbs[] = {{-1, {0, 0.9f}, {0, 1.4f}},     {0, {0, 1.4f}, {0, 1.6f}},
                               {0, {0, 1.35f}, {0.3f, 1.3f}},  {2, {0.3f, 1.3f}, {0.6f, 1.25f}},
                               {0, {0, 1.35f}, {-0.3f, 1.3f}}, {4, {-0.3f, 1.3f}, {-0.6f, 1.25f}},
                               {0, {0, 0.9f}, {0.15f, 0.5f}},  {6, {0.15f, 0.5f}, {0.2f, 0.1f}},
                               {0, {0, 0.9f}, {-0.15f, 0.5f}}, {8, {-0.15f, 0.5f}, {-0.2f, 0.1f}}};
    constexpr Vec2 kFeet{40.0f, 0.1f};
    std::vector<BodyId> limbs;
    ShapeDefinition shape;
    shape.group = -1;
    for (const Limb& limb : kLimbs) {
        const Vec2 middle = 0.5f * (limb.from + limb.to), half = 0.5f * (limb.to - limb.from);
        limbs.push_back(*createBody(world, {.position = WorldPosition{kFeet + middle}}));
        static_cast<void>(createShape(world, limbs.back(), capsule(-1.0f * half, half, 0.06f), shape));
        if (limb.parent < 0) continue;
        JointDefinition joint;
        joint.a = limbs[static_cast<std::size_t>(limb.parent)];
        joint.b = limbs.back();
        const Limb& parent = kLimbs[limb.parent];
        joint.anchorA = limb.from - 0.5f * (parent.from + parent.to);
        joint.anchorB = limb.from - middle;
        joint.limit = {.on = true, .lower = -0.5f, .upper = 0.5f};
        static_cast<void>(createJoint(world, joint));
    }
    std::vector<Vec2> outline;
    for (int i = 0; i < 24; ++i)
        outline.push_back(rotate(rotFromAngle(kTau * static_cast<float>(i) / 24.0f), {1.0f, 0.0f}));
    static_cast<void>(createJelly(world, {50.0, 1.1}, outline, {}));
}

int printShare(CallgrindCounts& counted) {
    const double crates = counted.next(), others = counted.next(), all = counted.next();
    const double share = (all - others) / crates;
    std::printf(
        "\n%d fixed-rotation crates, instructions: alone %.0f; a ragdoll and a jelly alone %.0f; all %.0f\n"
        "together, the crates cost %.3f times as much as alone (target %.1f)%s\n",
        kMixedCrates, crates, others, all, share, kCratesShare, share <= kCratesShare ? "" : "  MISSED");
    return crates > 0.0 && share <= kCratesShare ? 0 : 1;
}

}  // namespace

int runMixed(bool quick) {
    for (const int what : {1, 2, 3}) {
        World world;
        addFloor(world);
        if ((what & 1) != 0) addCrates(world);
        if ((what & 2) != 0) addOthers(world);
        for (int i = 0; i < 60; ++i) step(world, kTick);
        plumbMixedSteps(&world, quick ? 5 : 60);
    }
    return 0;
}

int measureMixed(const char* program, bool quick) {
    return countInstructions(program, "plumbMixedSteps", quick, printShare, "counted-mixed");
}

}  // namespace plumb::bench
