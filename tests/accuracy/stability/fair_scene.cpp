#include "tests/accuracy/stability/fair_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/model/joints.hpp"

namespace plumb::stability {

namespace {

constexpr int kColumns = 4;
constexpr double kCell = 2.0;   // side of the square cell in which each body starts, m
constexpr float kReach = 0.9f;  // maximum distance of a point of a body from its center, m
constexpr double kWalls = 0.5 * kColumns * kCell;

Vec2 at(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

}  // namespace

FairScene::FairScene(std::uint64_t seed) : random_{Random::seeded(seed)} {
    gravity_ = oneIn(5) ? 0.0 : between(0.5, 30.0);
    constexpr std::array<float, 3> kSteps{1.0f / 120.0f, 1.0f / 60.0f, 1.0f / 30.0f};
    step_ = kSteps[oneIn(3) ? random_.below(3) : 1];
    world_.settings.gravity = at(0.0, -gravity_);
    world_.settings.quality = static_cast<physics::Quality>(random_.below(5));
    world_.settings.automaticQuality = oneIn(3);
    world_.settings.sleeping = !oneIn(3);
    addPit();
    const auto rows = static_cast<int>(1 + random_.below(3));
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            if (!oneIn(3)) addBody(at((column + 0.5) * kCell - kWalls, (row + 0.5) * kCell));
        }
    }
    if (bodies_.empty()) addBody(at(0.0, kCell));
    for (std::uint32_t i = oneIn(2) ? random_.below(4) : 0; i > 0; --i) addHinge();
    startEnergy_ = mostEnergy_ = energy();
}

double FairScene::between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_.unit());
}

float FairScene::decades(double low, double high) {
    return static_cast<float>(low * std::exp(static_cast<double>(random_.unit()) * std::log(high / low)));
}

void FairScene::addPit() {
    const physics::ShapeDefinition stone{.friction = static_cast<float>(between(0.0, 1.0)),
                                         .bounciness = oneIn(3) ? random_.unit() : 0.0f};
    const auto pit = *physics::createBody(world_, {.kind = physics::BodyKind::Static});
    sound_ = physics::createShape(world_, pit, physics::box(at(20.0, 1.0), at(0.0, -1.0)), stone).ok();
    for (const double side : {-1.0, 1.0}) {
        const physics::Geometry wall = physics::box(at(1.0, 50.0), at(side * (kWalls + 1.0), 50.0));
        sound_ = physics::createShape(world_, pit, wall, stone).ok() && sound_;
    }
}

void FairScene::addShape(physics::BodyId body) {
    const physics::ShapeDefinition stuff{.density = decades(0.01, 100.0),
                                         .friction = static_cast<float>(between(0.0, 2.0)),
                                         .bounciness = oneIn(2) ? 0.0f : random_.unit()};
    const float size = kReach * decades(0.05, 1.0), thin = size * decades(0.05, 0.7);
    bool made = false;
    switch (random_.below(4)) {
        case 0: made = physics::createShape(world_, body, physics::circle(size), stuff).ok(); break;
        case 1:
            made = physics::createShape(world_, body, physics::box({0.7f * size, thin}), stuff).ok();
            break;
        case 2: {
            const float half = 0.5f * size;
            const physics::Geometry outline = physics::capsule({-half, 0.0f}, {half, 0.0f}, 0.7f * thin);
            made = physics::createShape(world_, body, outline, stuff).ok();
            break;
        }
        default: {
            const std::array<Vec2, 4> corners{Vec2{-0.7f * size, -thin}, Vec2{0.7f * size, -thin},
                                              Vec2{0.4f * size, thin}, Vec2{-0.1f * size, 0.7f * size}};
            made = physics::createPolygon(world_, body, corners, 0.0f, stuff).ok();
        }
    }
    sound_ = sound_ && made;
}

void FairScene::addBody(Vec2 middle) {
    physics::BodyDefinition definition;
    definition.position = physics::WorldPosition{middle};
    definition.angle = static_cast<float>(between(-3.0, 3.0));
    if (gravity_ == 0.0 || !oneIn(3)) {
        const double speed = static_cast<double>(decades(0.1, oneIn(4) ? 200.0 : 20.0));
        const double way = between(-3.15, 3.15);
        definition.velocity = at(speed * std::cos(way), speed * std::sin(way));
        definition.angularVelocity =
            static_cast<float>(between(-1.0, 1.0)) * decades(0.1, oneIn(4) ? 1e3 : 30.0);
    }
    definition.bullet = oneIn(8);
    definition.fixedRotation = oneIn(10);
    const auto body = physics::createBody(world_, definition);
    sound_ = sound_ && body.ok();
    if (!body) return;
    bodies_.push_back(*body);
    addShape(*body);
}

/// Connects two neighbouring bodies with a hinge at a point between them.
void FairScene::addHinge() {
    if (bodies_.size() < 2) return;
    const std::uint32_t first = random_.below(static_cast<std::uint32_t>(bodies_.size() - 1));
    const physics::BodyId a = bodies_[first], b = bodies_[first + 1];
    const physics::WorldPosition start = physics::positionOf(world_, a), end = physics::positionOf(world_, b);
    const Vec2 half = 0.5f * (end - start);
    const auto local = [&](physics::BodyId body, Vec2 arm) {
        return unrotate(physics::rotationOf(world_, body), arm);
    };
    const Rot rotation = inverse(physics::rotationOf(world_, a)) * physics::rotationOf(world_, b);
    const auto made = physics::createJoint(
        world_, {.kind = oneIn(4) ? physics::JointKind::Weld : physics::JointKind::Revolute,
                 .a = a,
                 .b = b,
                 .anchorA = local(a, half),
                 .anchorB = local(b, -half),
                 .referenceAngle = std::atan2(rotation.sin, rotation.cos)});
    sound_ = sound_ && made.ok();
}

double FairScene::energy() const {
    double sum = 0.0;
    for (const physics::BodyId body : bodies_) {
        const physics::BodyMotion& motion = world_.bodies.motion[body.index];
        const physics::BodyMass& mass = world_.bodies.mass[body.index];
        const auto spin = static_cast<double>(motion.angularVelocity);
        const auto speed = static_cast<double>(lengthSquared(motion.velocity));
        const double height = world_.bodies.pose[body.index].centre.y;
        sum += static_cast<double>(mass.mass) * (0.5 * speed + gravity_ * height) +
               0.5 * static_cast<double>(mass.inertia) * spin * spin;
    }
    return sum;
}

void FairScene::run() {
    const std::uint32_t steps = 20 + random_.below(80);
    for (std::uint32_t i = 0; i < steps && sound_; ++i) {
        physics::step(world_, step_);
        const double now = energy();
        sound_ = std::isfinite(now) && world_.quarantined.empty();
        mostEnergy_ = std::max(mostEnergy_, now);
    }
}

}  // namespace plumb::stability
