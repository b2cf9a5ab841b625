#include "tests/physics/support/golden_scenes.hpp"

#include "core/random.hpp"
#include "math/portable.hpp"
#include "physics/kernels.hpp"
#include "physics/model/fields.hpp"
#include "physics/simulation.hpp"
#include "physics/soft/softbody.hpp"

namespace plumb::physics::test {

namespace {

// Programs that compare state hashes also compare those of the scalar kernels, so these must be linked in.
[[maybe_unused]] const bool kLinked = (linkScalarKernels(), true);

BodyId add(World& world, const BodyDefinition& body, const Geometry& outline,
           const ShapeDefinition& shape = {}) {
    const BodyId made = *createBody(world, body);
    static_cast<void>(createShape(world, made, outline, shape));
    return made;
}
BodyId crate(World& world, WorldPosition place, Vec2 half = {0.5f, 0.5f}, float angle = 0.0f) {
    return add(world, {.position = place, .angle = angle}, box(half));
}
BodyId wall(World& world, WorldPosition place, Vec2 half, const ShapeDefinition& shape = {}) {
    return add(world, {.kind = BodyKind::Static, .position = place}, box(half), shape);
}
void tie(World& world, BodyId a, Vec2 anchorA, BodyId b, Vec2 anchorB) {
    static_cast<void>(createJoint(world, {.a = a, .b = b, .anchorA = anchorA, .anchorB = anchorB}));
}

World makeWorld() {
    World world;
    world.settings.gravity = {0.0f, -10.0f};
    return world;
}
World makeGround() {
    World world = makeWorld();
    wall(world, {0.0, -1.0}, {40.0f, 1.0f});
    return world;
}

World makePyramid() {
    World world = makeGround();
    for (int row = 0; row < 12; ++row) {
        for (int i = row; i < 12; ++i) crate(world, {1.1 * i - 0.55 * row - 6.0, 0.5 + 1.0 * row});
    }
    return world;
}

World makeTumbler() {
    World world = makeWorld();
    const BodyId drum = *createBody(world, {.kind = BodyKind::Kinematic, .angularVelocity = 0.8f});
    for (const float side : {-1.0f, 1.0f}) {
        static_cast<void>(createShape(world, drum, box({0.5f, 6.0f}, {5.5f * side, 0.0f})));
        static_cast<void>(createShape(world, drum, box({6.0f, 0.5f}, {0.0f, 5.5f * side})));
    }
    for (int i = 0; i < 120; ++i) {
        const WorldPosition place{-3.3 + 0.6 * (i % 12), -3.0 + 0.6 * (i / 12)};
        add(world, {.position = place}, i % 2 == 0 ? box({0.2f, 0.2f}) : circle(0.22f));
    }
    return world;
}

/// Adds a torso with head, arms and legs that do not collide with each other.
void addRagdoll(World& world, WorldPosition place, int group) {
    ShapeDefinition shape;
    shape.group = -group;
    const auto part = [&](Vec2 at, const Geometry& outline) {
        return add(world, {.position = place + at}, outline, shape);
    };
    const BodyId body = part({}, box({0.2f, 0.4f})), head = part({0.0f, 0.65f}, circle(0.2f));
    tie(world, body, {0.0f, 0.45f}, head, {0.0f, -0.2f});
    for (const float side : {-1.0f, 1.0f}) {
        const BodyId arm = part({0.5f * side, 0.3f}, capsule({-0.25f, 0.0f}, {0.25f, 0.0f}, 0.08f));
        const BodyId leg = part({0.12f * side, -0.75f}, capsule({0.0f, -0.3f}, {0.0f, 0.3f}, 0.09f));
        tie(world, body, {0.25f * side, 0.3f}, arm, {-0.25f * side, 0.0f});
        tie(world, body, {0.12f * side, -0.4f}, leg, {0.0f, 0.35f});
    }
}

World makeRagdolls() {
    World world = makeGround();
    for (int i = 0; i < 12; ++i)
        addRagdoll(world, {-3.0 + 2.0 * (i % 4) + 0.1 * i, 2.0 + 2.5 * (i / 4)}, i + 1);
    return world;
}

World makeBridge() {
    World world = makeWorld();
    BodyId last = wall(world, {-10.5, 0.0}, {0.5f, 0.5f});
    Vec2 end{0.5f, 0.0f};
    for (int i = 0; i < 20; ++i) {
        const BodyId plank = crate(world, {-9.5 + i, 0.0}, {0.48f, 0.1f});
        tie(world, last, end, plank, {-0.5f, 0.0f});
        last = plank, end = {0.5f, 0.0f};
    }
    tie(world, last, end, wall(world, {10.5, 0.0}, {0.5f, 0.5f}), {-0.5f, 0.0f});
    for (int i = 0; i < 8; ++i)
        crate(world, {-4.0 + i, 2.0 + 0.3 * i}, {0.3f, 0.3f}, 0.2f * static_cast<float>(i));
    return world;
}

World makeHeavyBall() {
    World world = makeWorld();
    BodyId last = wall(world, {0.0, 10.0}, {0.2f, 0.2f});
    for (int i = 0; i < 15; ++i) {
        const BodyId link = crate(world, {0.25 + 0.5 * i, 10.0}, {0.24f, 0.06f});
        tie(world, last, i == 0 ? Vec2{} : Vec2{0.25f, 0.0f}, link, {-0.25f, 0.0f});
        last = link;
    }
    ShapeDefinition lead;
    lead.density = 80.0f;
    const BodyId ball = add(world, {.position = {8.2, 10.0}}, circle(0.7f), lead);
    tie(world, last, {0.25f, 0.0f}, ball, {-0.7f, 0.0f});
    for (int i = 0; i < 6; ++i) crate(world, {-4.0, 0.5 + i});
    wall(world, {0.0, -1.0}, {20.0f, 1.0f});
    return world;
}

World makeCardHouse() {
    World world = makeGround();
    constexpr float kLean = 0.25f;  // rad
    const Vec2 half{0.03f, 0.5f};
    const float rise = 0.5f * cosine(kLean) + 0.03f * sine(kLean);
    for (int level = 0; level < 2; ++level) {
        const double base = 2.0 * static_cast<double>(level) * static_cast<double>(rise) + 0.062 * level;
        for (int i = level; i < 3; ++i) {
            const double middle = 0.62 * i - 0.31 * level;
            crate(world, {middle - 0.14, base + static_cast<double>(rise)}, half, -kLean);
            crate(world, {middle + 0.14, base + static_cast<double>(rise)}, half, kLean);
        }
        for (int i = level; i < 2; ++i)
            crate(world, {0.62 * i + 0.31 - 0.31 * level, base + 2.0 * static_cast<double>(rise) + 0.031},
                  {0.4f, 0.03f});
    }
    return world;
}

World makeCradle() {
    World world = makeWorld();
    ShapeDefinition steel;
    steel.bounciness = 1.0f;
    steel.friction = 0.0f;
    const BodyId beam = wall(world, {0.0, 5.0}, {3.0f, 0.1f});
    for (int i = 0; i < 5; ++i) {
        const float x = 0.81f * static_cast<float>(i - 2);
        const bool pulled = i == 0;
        const WorldPosition place = pulled ? WorldPosition{static_cast<double>(x) - 2.0, 3.0}
                                           : WorldPosition{static_cast<double>(x), 2.0};
        const BodyId ball = add(world, {.position = place}, circle(0.4f), steel);
        static_cast<void>(createJoint(world, {.kind = JointKind::Distance,
                                              .a = beam,
                                              .b = ball,
                                              .anchorA = {x, 0.0f},
                                              .length = pulled ? std::sqrt(8.0f) : 3.0f}));
    }
    return world;
}

World makeBilliards() {
    World world = makeWorld();
    world.settings.gravity = {};
    ShapeDefinition ivory;
    ivory.bounciness = 0.95f;
    ivory.friction = 0.05f;
    for (const float side : {-1.0f, 1.0f}) {
        wall(world, {6.0 * static_cast<double>(side), 0.0}, {0.2f, 3.2f}, ivory);
        wall(world, {0.0, 3.0 * static_cast<double>(side)}, {6.2f, 0.2f}, ivory);
    }
    for (int row = 0; row < 5; ++row) {
        for (int i = 0; i <= row; ++i)
            add(world, {.position = {1.0 + 0.45 * row, 0.52 * i - 0.26 * row}, .linearDrag = 0.2f},
                circle(0.25f), ivory);
    }
    add(world, {.position = {-4.0, 0.03}, .velocity = {25.0f, 0.0f}, .linearDrag = 0.2f, .bullet = true},
        circle(0.25f), ivory);
    return world;
}

World makeBuoyancy() {
    World world = makeGround();
    FieldDefinition water{.kind = FieldKind::Buoyancy, .region = RegionKind::Box, .place = {0.0, 2.0}};
    water.half = {15.0f, 2.0f};
    water.density = 2.0f;
    water.linearDrag = water.angularDrag = 1.0f;
    static_cast<void>(createField(world, water));
    Random random = Random::seeded(3);
    for (int i = 0; i < 30; ++i) {
        const float angle = random.between(-1.0f, 1.0f);
        const Vec2 half{random.between(0.2f, 0.6f), random.between(0.2f, 0.6f)};
        crate(world, {-7.0 + 1.5 * (i % 10), 4.5 + 1.5 * (i / 10)}, half, angle);
    }
    return world;
}

World makeSoftBody() {
    World world = makeGround();
    std::vector<Vec2> ring;
    for (int i = 0; i < 16; ++i)
        ring.push_back(rotate(rotFromAngle(kPi * static_cast<float>(i) / 8.0f), {0.8f, 0.0f}));
    static_cast<void>(createJelly(world, {0.0, 2.0}, ring));
    static_cast<void>(createJelly(world, {0.5, 4.0}, ring));
    static_cast<void>(createRope(world, {-5.0, 6.0}, {-1.0, 6.0}, 20));
    for (int i = 0; i < 6; ++i) crate(world, {-2.5 + i, 7.0}, {0.3f, 0.2f});
    return world;
}

World makeCloth() {
    World world = makeGround();
    const SoftBodyId cloth = *createCloth(world, {-3.0, 4.0}, {6.0f, 1.0f}, 25, 5);
    for (const int corner : {0, 24}) static_cast<void>(pinParticle(world, cloth, corner, true));
    add(world, {.position = {0.3, 7.0}}, circle(0.5f));
    crate(world, {-1.0, 9.0}, {0.4f, 0.3f});
    for (const double y : {0.5, 1.5}) crate(world, {2.0, y});
    return world;
}

World makeConveyor() {
    World world = makeWorld();
    for (int i = 0; i < 3; ++i) {
        ShapeDefinition belt;
        belt.surfaceSpeed = i % 2 == 0 ? 3.0f : -3.0f;
        wall(world, {i % 2 == 0 ? -2.0 : 2.0, -3.0 * i}, {6.0f, 0.2f}, belt);
    }
    for (int i = 0; i < 24; ++i)
        add(world, {.position = {-7.0 + 1.1 * (i % 8), 1.0 + 1.1 * (i / 8)}},
            i % 3 == 0 ? circle(0.3f) : box({0.4f, 0.25f}));
    return world;
}

World makeExplosion() {
    World world = makeGround();
    for (int i = 0; i < 40; ++i) crate(world, {-2.0 + 1.02 * (i % 5), 0.5 + 1.0 * (i / 5)});
    return world;
}

void explodeOnce(World& world, int step) {
    if (step != 40) return;
    FieldDefinition blast{.kind = FieldKind::Explosion, .place = {0.0, 2.0}, .radius = 5.0f};
    blast.strength = 12.0f;
    static_cast<void>(createField(world, blast));
}

/// Boxes like in a platformer, without rotation or friction: their contacts use kernels of their own.
World makeUpright() {
    World world = makeWorld();
    ShapeDefinition ice;
    ice.friction = 0.0f;
    wall(world, {0.0, -1.0}, {8.0f, 1.0f}, ice);
    for (const double side : {-8.0, 8.0}) wall(world, {side, 5.0}, {0.5f, 6.0f}, ice);
    for (int i = 0; i < 80; ++i) {
        BodyDefinition body{.position = {-6.0 + 1.15 * (i % 11) + 0.2 * (i / 11 % 2), 0.6 + 1.2 * (i / 11)}};
        body.fixedRotation = true;
        add(world, body, box({0.5f, 0.4f + 0.1f * static_cast<float>(i % 2)}), ice);
    }
    return world;
}

/// Four arms with motors and limits, of which the last link is a boom, that sweep crates off a table, and
/// four-bar linkages that a motor drives.
World makeMachines() {
    World world = makeGround();
    for (int i = 0; i < 4; ++i) {
        const double x = 8.0 * i - 12.0;
        const float side = i % 2 == 0 ? 1.0f : -1.0f, torque = 60.0f * static_cast<float>(i + 1);
        BodyId last = wall(world, {x, 3.0}, {0.2f, 0.2f});
        for (int link = 0; link < 4; ++link) {
            const BodyId next = crate(world, {x, 3.5 + link}, {0.08f, 0.5f});
            JointDefinition joint{
                .kind = link < 3 ? JointKind::Revolute : JointKind::Prismatic, .a = last, .b = next};
            joint.anchorA = link == 0 ? Vec2{} : Vec2{0.0f, 0.5f};
            joint.anchorB = {0.0f, -0.5f};
            joint.axis = {0.0f, 1.0f};
            joint.motor = {true, link < 3 ? -side : 0.5f, torque};
            joint.limit = {link > 0, -0.7f, 0.7f};
            static_cast<void>(createJoint(world, joint));
            last = next;
        }
        for (int k = 0; k < 3; ++k)
            crate(world, {x + 2.5 * static_cast<double>(side), 0.3 + 0.6 * k}, {0.3f, 0.3f});
        const BodyId base = wall(world, {x, 12.0}, {0.1f, 0.1f});
        const BodyId crank = crate(world, {x, 12.3}, {0.05f, 0.3f}),
                     rod = crate(world, {x + 1.0, 12.6}, {1.0f, 0.05f});
        const BodyId rocker = crate(world, {x + 2.0, 12.0}, {0.05f, 0.6f});
        static_cast<void>(createJoint(world, {.a = base,
                                              .b = crank,
                                              .anchorB = {0.0f, -0.3f},
                                              .motor = {true, 3.0f * static_cast<float>(i + 1), 400.0f}}));
        tie(world, crank, {0.0f, 0.3f}, rod, {-1.0f, 0.0f});
        tie(world, rod, {1.0f, 0.0f}, rocker, {0.0f, 0.6f});
        tie(world, rocker, {0.0f, -0.6f}, base, {2.0f, -0.6f});
    }
    return world;
}

}  // namespace

const std::vector<GoldenScene>& goldenScenes() {
    static const std::vector<GoldenScene> kScenes{
        {"pyramid", makePyramid, 120},
        {"tumbler", makeTumbler, 180},
        {"ragdolls", makeRagdolls, 180, true},
        {"bridge", makeBridge, 180, true},
        {"heavy_ball", makeHeavyBall, 180, true},
        {"card_house", makeCardHouse, 180},
        {"cradle", makeCradle, 240, true},
        {"billiards", makeBilliards, 180},
        {"buoyancy", makeBuoyancy, 180},
        {"soft_body", makeSoftBody, 120},
        {"cloth", makeCloth, 120},
        {"conveyor", makeConveyor, 180},
        {"explosion", makeExplosion, 150, false, true, explodeOnce},
        {"upright", makeUpright, 180},
        {"machines", makeMachines, 240, true},
    };
    return kScenes;
}

}  // namespace plumb::physics::test
