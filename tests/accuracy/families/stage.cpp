#include "tests/accuracy/families/stage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/random.hpp"
#include "physics/debug_draw.hpp"
#include "physics/workspace.hpp"

namespace plumb::families {

namespace {

constexpr scenes::BodyHandle kGone{};
/// Practically unlimited joint force or torque, N or N m; still finite after scaling the scene up.
constexpr float kUnlimited = 1.0e15f;

/// Returns 0..count-1, shuffled unless the seed is 0.
std::vector<std::uint32_t> orderOf(std::size_t count, std::uint64_t seed) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    if (seed == 0) return order;
    Random random = Random::seeded(seed);
    for (std::size_t i = count; i > 1; --i)
        std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
    return order;
}

/// Scales all lengths and speeds of the physics settings.
void scaleSettings(physics::Settings& settings, float scale) {
    for (float* length :
         {&settings.slop, &settings.speculativeDistance, &settings.recycleDistance, &settings.boundsMargin,
          &settings.pushSpeed, &settings.bounceSpeed, &settings.maxSpeed, &settings.tolerance})
        *length *= scale;
}

}  // namespace

Stage::Stage(const Blueprint& plan, const Variation& variation) : plan_{plan}, variation_{variation} {
    // Exact rotations by quarter turns, without rounding.
    constexpr std::array<Rot, 4> kTurns{Rot{1.0f, 0.0f}, Rot{0.0f, 1.0f}, Rot{-1.0f, 0.0f}, Rot{0.0f, -1.0f}};
    turn_ = kTurns[static_cast<std::size_t>(variation.placement.quarterTurns & 3)];
    scale_ = variation.placement.scale;
    open();
    build();
}

void Stage::open() {
    scenes::WorldSetup setup;
    setup.gravity = scale_ * placed(plan_.gravity);
    setup.sleeping = variation_.sleeping;
    setup.threads = variation_.threads;
    setup.originX = variation_.placement.originX;
    setup.originY = variation_.placement.originY;
    if (variation_.peer != nullptr) {
        scene_ = variation_.peer->open(setup);
        return;
    }
    auto made = std::make_unique<scenes::PlumbWorld>(setup);
    plumb_ = made.get();
    scene_ = std::move(made);
    physics::Settings& settings = plumb_->world().settings;
    settings.automaticQuality = variation_.quality == physics::kQualityOfWorld;
    if (!settings.automaticQuality) settings.quality = variation_.quality;
    settings.directJoints = variation_.directJoints;
    settings.continuous = variation_.continuous;
    settings.broadPhase = variation_.broadPhase;
    if (variation_.tune) variation_.tune(settings);
    scaleSettings(settings, scale_);
    if (variation_.allEffects) plumb_->world().manifest.pinnedOn = ~0u >> (32 - physics::kEffects);
    for (int i = 0; i < variation_.delay; ++i) plumb_->step(kStep);
}

void Stage::build() {
    handles_.assign(plan_.bodies.size(), kGone);
    for (const std::uint32_t body : orderOf(plan_.bodies.size(), variation_.shuffle)) {
        if (body < variation_.dropped.size() && variation_.dropped[body]) continue;
        make(body, plan_.bodies[body]);
    }
    for (const std::uint32_t joint : orderOf(plan_.joints.size(), variation_.shuffle))
        make(plan_.joints[joint]);
    scene_->finish();
    if (plan_.extra && plumb_ != nullptr) plan_.extra(*this);
}

void Stage::make(std::uint32_t body, const BodyPlan& plan) {
    BodySetup setup = plan.setup;
    setup.position = scale_ * placed(setup.position);
    setup.angle = placedAngle(setup.angle);
    setup.velocity = scale_ * placed(setup.velocity);
    setup.spin *= sign();
    setup.sleepSpeed *= scale_;
    handles_[body] = scene_->createBody(setup);
    for (const ShapeSetup& shape : plan.shapes)
        scene_->addShape(handles_[body], placed(shape.outline), placed(shape.material));
    for (std::vector<Vec2> loop : plan.loops) {
        for (Vec2& point : loop) point = local(point);
        if (variation_.placement.mirrored) std::reverse(loop.begin(), loop.end());
        scene_->addLoop(handles_[body], loop, placed(plan.loopMaterial));
    }
    if (plan.mass > 0.0f) scene_->setMass(handles_[body], plan.mass * scale_ * scale_);
}

void Stage::make(const JointSetup& joint) {
    if (!has(joint.a.index) || !has(joint.b.index)) return;
    JointSetup made = joint;
    made.a = handles_[joint.a.index];
    made.b = handles_[joint.b.index];
    made.anchorA = local(joint.anchorA);
    made.anchorB = local(joint.anchorB);
    made.axis = {sign() * joint.axis.x, joint.axis.y};
    made.length *= scale_;
    const bool slides = joint.kind == scenes::JointKind::Slider;
    // Masses are proportional to scale^2, so torques to scale^4 and forces to scale^3. The coordinate of a
    // slider is measured along its axis, which is mirrored too, so it keeps its sign.
    made.maxForce = std::min(joint.maxForce, kUnlimited) * std::pow(scale_, slides ? 3.0f : 4.0f);
    const float unit = slides ? scale_ : sign();
    made.reference = sign() * joint.reference;
    made.speed = unit * joint.speed;
    made.lower = unit * (unit < 0.0f ? joint.upper : joint.lower);
    made.upper = unit * (unit < 0.0f ? joint.lower : joint.upper);
    scene_->addJoint(made);
}

Vec2 Stage::placed(Vec2 direction) const { return rotate(turn_, {sign() * direction.x, direction.y}); }

Vec2 Stage::unplaced(Vec2 direction) const {
    const Vec2 turned = unrotate(turn_, direction);
    return {sign() * turned.x, turned.y};
}

Vec2 Stage::local(Vec2 point) const { return scale_ * Vec2{sign() * point.x, point.y}; }

float Stage::placedAngle(float angle) const {
    constexpr std::array<float, 4> kAngles{0.0f, 0.5f * kPi, kPi, -0.5f * kPi};
    return sign() * angle + kAngles[static_cast<std::size_t>(variation_.placement.quarterTurns & 3)];
}

Outline Stage::placed(const Outline& outline) const {
    Outline made = outline;
    for (std::size_t i = 0; i < outline.count; ++i) made.points[i] = local(outline.points[i]);
    // Mirroring inverts the order of corners, so it is reversed to stay counter-clockwise.
    if (variation_.placement.mirrored && outline.count > 2)
        std::reverse(made.points.begin(), made.points.begin() + outline.count);
    made.centre = local(outline.centre);
    made.half = scale_ * outline.half;
    made.radius = scale_ * outline.radius;
    return made;
}

Material Stage::placed(Material material) const {
    // The surface speed has a direction along the outline, which mirroring inverts.
    material.surfaceSpeed *= sign() * scale_;
    material.oneWayDirection.x *= sign();
    return material;
}

physics::WorldPosition Stage::placeOf(Vec2 point) const {
    const Vec2 at = vectorOf(point);
    const Placement& placement = variation_.placement;
    return physics::WorldPosition{placement.originX, placement.originY} + at;
}

Vec2 Stage::pointOf(physics::WorldPosition place) const {
    const Placement& placement = variation_.placement;
    return unplaced((1.0f / scale_) * (place - physics::WorldPosition{placement.originX, placement.originY}));
}

bool Stage::isAsleep(std::uint32_t body) const {
    return plumb_ != nullptr &&
           !physics::isAwake(std::as_const(*plumb_).world(), plumb_->idOf(handles_[body]));
}

double Stage::hitSpeedOf(std::uint32_t body) const {
    if (plumb_ == nullptr) return 0.0;
    const physics::World& world = std::as_const(*plumb_).world();
    const physics::Workspace* work = physics::lastStepOf(world);
    if (work == nullptr || work->swept.empty()) return 0.0;
    const std::uint32_t index = plumb_->idOf(handles_[body]).index;
    double impulse = 0.0;  // sum of normal impulses, N s
    for (const physics::Contact& hit : work->madeHits) {
        if (hit.bodyA == index || hit.bodyB == index)
            impulse += static_cast<double>(std::fabs(hit.impulse0) + std::fabs(hit.impulse1));
    }
    return impulse * static_cast<double>(world.bodies.mass[index].inverseMass / scale_);
}

bool Stage::has(std::uint32_t body) const {
    return body < handles_.size() && handles_[body].index != kGone.index;
}

scenes::Point Stage::positionOf(std::uint32_t body) const {
    const scenes::Pose pose = scene_->poseOf(handles_[body]);
    const auto cos = static_cast<double>(turn_.cos), sin = static_cast<double>(turn_.sin);
    const auto scale = static_cast<double>(scale_);
    const double x = (cos * pose.x + sin * pose.y) / scale, y = (cos * pose.y - sin * pose.x) / scale;
    return {static_cast<double>(sign()) * x, y};
}

Rot Stage::rotationOf(std::uint32_t body) const {
    const scenes::Pose pose = scene_->poseOf(handles_[body]);
    const Rot turned = inverse(turn_) * Rot{static_cast<float>(pose.cos), static_cast<float>(pose.sin)};
    return {turned.cos, sign() * turned.sin};
}

Vec2 Stage::velocityOf(std::uint32_t body) const {
    return unplaced((1.0f / scale_) * scene_->velocityOf(handles_[body]));
}

float Stage::spinOf(std::uint32_t body) const { return sign() * scene_->spinOf(handles_[body]); }

double Stage::displacementOf(std::uint32_t body) const {
    const scenes::Point now = positionOf(body);
    const Vec2 start = startOf(body);
    return std::hypot(now.x - static_cast<double>(start.x), now.y - static_cast<double>(start.y));
}

double Stage::turnOf(std::uint32_t body) const {
    const Rot from = rotFromAngle(plan_.bodies[body].setup.angle);
    return static_cast<double>(angleOf(between(from, rotationOf(body))));
}

void Stage::setVelocity(std::uint32_t body, Vec2 velocity) {
    if (has(body)) scene_->setVelocity(handles_[body], scale_ * placed(velocity));
}

void Stage::setSpin(std::uint32_t body, float spin) {
    if (has(body)) scene_->setSpin(handles_[body], sign() * spin);
}

void Stage::moveTo(std::uint32_t body, Vec2 position, float angle) {
    if (has(body)) scene_->moveTo(handles_[body], scale_ * placed(position), placedAngle(angle), kStep);
}

void Stage::setMass(std::uint32_t body, float kilograms) {
    if (has(body)) scene_->setMass(handles_[body], kilograms * scale_ * scale_);
}

void Stage::teleport(std::uint32_t body, Vec2 position, float angle) {
    if (!has(body)) return;
    scene_->setPosition(handles_[body], scale_ * placed(position), placedAngle(angle));
    teleported_.push_back(body);
}

bool Stage::wasTeleported(std::uint32_t body) const {
    return std::find(teleported_.begin(), teleported_.end(), body) != teleported_.end();
}

void Stage::destroy(std::uint32_t body) {
    if (!has(body)) return;
    scene_->destroy(handles_[body]);
    handles_[body] = kGone;
}

std::uint32_t Stage::spawn(const BodyPlan& plan) {
    handles_.push_back(kGone);
    const auto body = static_cast<std::uint32_t>(handles_.size() - 1);
    if (body < variation_.dropped.size() && variation_.dropped[body]) return body;
    make(body, plan);
    return body;
}

void Stage::step() {
    teleported_.clear();
    if (plan_.drive) plan_.drive(*this, steps_);
    if (plumb_ != nullptr && variation_.restoreEvery > 0 && steps_ % variation_.restoreEvery == 0) {
        physics::World copy = plumb_->world();
        plumb_->world() = std::move(copy);
    }
    scene_->step(kStep);
    ++steps_;
}

}  // namespace plumb::families
