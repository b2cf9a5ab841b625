// Measures how the step time grows with the number of objects of one kind: bullets,
// joints, fields, sleeping bodies, … Objects are distributed with constant density.
// An object that needs a body, such as a joint, has its own; so both numbers grow
// alike, and the time is proportional unless each object is tested against all bodies.

#include "tests/accuracy/families/costs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "core/clock.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "math/rot.hpp"
#include "physics/model/fields.hpp"
#include "physics/model/joints.hpp"
#include "physics/simulation.hpp"
#include "physics/soft/softbody.hpp"

namespace plumb::families {

namespace {

using physics::BodyId;
using physics::BodyKind;
using physics::JointKind;

constexpr float kStepSeconds = 1.0f / 60.0f;
constexpr double kCell = 3.0;  // m, side of the square cell of each object
constexpr int kWarmSteps = 40;
constexpr int kTimedSteps = 60;

/// A world for cost measurements, whose size is proportional to the number of objects.
struct CostScene {
    physics::World world;
    Random random = Random::seeded(7);
    int count = 0;
    BodyId ground;
    std::vector<BodyId> bodies;

    explicit CostScene(int things) : count{things} {
        world.settings.gravity = {0.0f, -10.0f};
        world.settings.sleeping = false;
        ground = *physics::createBody(world, {.kind = BodyKind::Static});
    }

    [[nodiscard]] int columns() const { return static_cast<int>(std::ceil(std::sqrt(count))); }
    [[nodiscard]] physics::WorldPosition cell(int i) const {
        return {kCell * (i % columns()), kCell * (1.0 + static_cast<double>(i / columns()))};
    }
    BodyId body(physics::WorldPosition at, const physics::Geometry& outline,
                physics::BodyDefinition definition = {}, const physics::ShapeDefinition& shape = {}) {
        definition.position = at;
        const BodyId made = *physics::createBody(world, definition);
        static_cast<void>(*physics::createShape(world, made, outline, shape));
        bodies.push_back(made);
        return made;
    }
    /// Adds a static platform below a cell, so that no body falls out of the cell.
    void shelf(physics::WorldPosition at) {
        body({at.x, at.y - 0.6}, physics::box({1.2f, 0.1f}), {.kind = BodyKind::Static});
    }
    Vec2 anyDirection(float speed) {
        const SinCos parts = sinCos(random.between(0.0f, kTau));
        return {speed * parts.cos, speed * parts.sin};
    }
    void joint(physics::JointDefinition definition) {
        static_cast<void>(*physics::createJoint(world, definition));
    }
};

// ---- objects -------------------------------------------------------------------------------------

/// Adds moving balls between walls. Without walls they would fly apart, earlier in small scenes than in large
/// ones, and then collide less often.
void balls(CostScene& scene, float speed, bool bullet) {
    scene.world.settings.gravity = {};
    const auto half = static_cast<float>(0.5 * kCell * scene.columns());
    const Vec2 middle{half - static_cast<float>(0.5 * kCell), half + static_cast<float>(0.5 * kCell)};
    for (const float side : {-half - 1.0f, half + 1.0f}) {
        for (const bool upright : {false, true}) {
            const Vec2 out = upright ? Vec2{side, 0.0f} : Vec2{0.0f, side};
            const Vec2 size = upright ? Vec2{1.0f, half + 2.0f} : Vec2{half + 2.0f, 1.0f};
            static_cast<void>(*physics::createShape(scene.world, scene.ground,
                                                    physics::box(size, middle + out), {.bounciness = 1.0f}));
        }
    }
    for (int i = 0; i < scene.count; ++i)
        scene.body(scene.cell(i), physics::circle(0.2f),
                   {.velocity = scene.anyDirection(speed), .bullet = bullet}, {.bounciness = 1.0f});
}

void slowBalls(CostScene& scene) { balls(scene, 1.0f, false); }
void fastBalls(CostScene& scene) { balls(scene, 60.0f, false); }
void bullets(CostScene& scene) { balls(scene, 60.0f, true); }

void restingCrates(CostScene& scene) {
    for (int i = 0; i < scene.count; ++i) {
        scene.shelf(scene.cell(i));
        scene.body(scene.cell(i), physics::box({0.5f, 0.5f}));
    }
}

void sleepingCrates(CostScene& scene) {
    scene.world.settings.sleeping = true;
    restingCrates(scene);
    // A body that never sleeps, as a step with sleeping bodies only would be skipped.
    scene.body({-10.0, 100.0}, physics::circle(0.5f), {.gravityScale = 0.0f, .canSleep = false});
}

void kinematicSweepers(CostScene& scene) {
    for (int i = 0; i < scene.count; ++i)
        scene.body(scene.cell(i), physics::box({0.5f, 0.1f}),
                   {.kind = BodyKind::Kinematic, .angularVelocity = 2.0f});
}

void triggers(CostScene& scene) {
    for (int i = 0; i < scene.count; ++i) {
        scene.shelf(scene.cell(i));
        scene.body(scene.cell(i), physics::box({0.4f, 0.5f}));
        scene.body(scene.cell(i), physics::circle(0.6f), {.kind = BodyKind::Static}, {.isTrigger = true});
    }
}

void oneWayPlatforms(CostScene& scene) {
    for (int i = 0; i < scene.count; ++i) {
        const physics::WorldPosition at = scene.cell(i);
        scene.body({at.x, at.y - 0.6}, physics::box({1.2f, 0.1f}), {.kind = BodyKind::Static},
                   {.oneWay = true, .oneWayDirection = {0.0f, 1.0f}});
        scene.body(at, physics::box({0.5f, 0.5f}));
    }
}

void conveyors(CostScene& scene) {
    for (int i = 0; i < scene.count; ++i) {
        const physics::WorldPosition at = scene.cell(i);
        scene.body({at.x, at.y - 0.6}, physics::box({1.2f, 0.1f}), {.kind = BodyKind::Static},
                   {.surfaceSpeed = 0.1f});
        scene.body(at, physics::box({0.5f, 0.5f}));
    }
}

template <JointKind kKind>
void joints(CostScene& scene) {
    for (int i = 0; i < scene.count; ++i) {
        const physics::WorldPosition at = scene.cell(i);
        const BodyId hook = scene.body(at, physics::circle(0.1f), {.kind = BodyKind::Static}, {.mask = 0});
        const BodyId bob = scene.body({at.x + 1.0, at.y}, physics::circle(0.3f), {}, {.mask = 0});
        physics::JointDefinition joint{.kind = kKind, .a = hook, .b = bob, .anchorB = {-1.0f, 0.0f}};
        joint.target = {at.x, at.y};
        if (kKind == JointKind::Distance || kKind == JointKind::Mouse) joint.anchorB = {};
        if (kKind == JointKind::Wheel) joint.spring = {.on = true, .hertz = 4.0f, .dampingRatio = 0.7f};
        if (kKind == JointKind::Mouse) joint.spring = {.on = true, .hertz = 2.0f, .dampingRatio = 0.7f};
        scene.joint(joint);
    }
}

void chainLinks(CostScene& scene) {
    constexpr int kLinks = 20;
    for (int i = 0; i < scene.count; ++i) {
        const bool first = i % kLinks == 0;
        const physics::WorldPosition at = scene.cell(i / kLinks);
        const physics::WorldPosition here{at.x + 0.5 * (i % kLinks), at.y};
        const BodyId above = first ? scene.ground : scene.bodies.back();
        const Vec2 anchor =
            first ? Vec2{static_cast<float>(here.x - 0.25), static_cast<float>(here.y)} : Vec2{0.25f, 0.0f};
        const BodyId link = scene.body(here, physics::box({0.25f, 0.05f}), {}, {.mask = 0});
        scene.joint({.kind = JointKind::Revolute,
                     .a = above,
                     .b = link,
                     .anchorA = anchor,
                     .anchorB = {-0.25f, 0.0f}});
    }
}

template <physics::FieldKind kKind>
void fields(CostScene& scene) {
    for (int i = 0; i < scene.count; ++i) {
        scene.body(scene.cell(i), physics::circle(0.3f), {.gravityScale = 0.0f});
        physics::FieldDefinition field;
        field.kind = kKind;
        field.region = physics::RegionKind::Box;
        field.place = scene.cell(i);
        field.half = {1.0f, 1.0f};
        field.radius = 1.0f;
        field.acceleration = {0.0f, 0.1f};
        field.velocity = {0.1f, 0.0f};
        field.strength = 0.1f;
        static_cast<void>(*physics::createField(scene.world, field));
    }
}

/// Adds attractors without bounds, which act on all bodies, to a constant number of bodies.
void endlessAttractors(CostScene& scene) {
    for (int i = 0; i < 500; ++i)
        scene.body({kCell * (i % 25), kCell * static_cast<double>(i / 25)}, physics::circle(0.3f),
                   {.gravityScale = 0.0f});
    physics::FieldDefinition field;
    field.kind = physics::FieldKind::Attractor;
    field.strength = 0.01f;
    field.length = 1.0f;
    for (int i = 0; i < scene.count; ++i) {
        field.place = {5.0 * i, -20.0};
        static_cast<void>(*physics::createField(scene.world, field));
    }
}

void jellies(CostScene& scene) {
    for (int i = 0; i < scene.count; ++i) {
        scene.shelf(scene.cell(i));
        std::array<Vec2, 12> outline;
        for (std::size_t k = 0; k < outline.size(); ++k)
            outline[k] = 0.4f * rotate(rotFromAngle(kTau * static_cast<float>(k) / 12.0f), {1.0f, 0.0f});
        static_cast<void>(*physics::createJelly(scene.world, scene.cell(i), outline));
    }
}

// ---- work in each step ---------------------------------------------------------------------------

void nothing(CostScene&, int) {}

/// Destroys the bodies created in the previous step and creates as many new ones.
void respawn(CostScene& scene, int) {
    for (const BodyId body : scene.bodies) physics::destroyBody(scene.world, body);
    scene.bodies.clear();
    for (int i = 0; i < scene.count; ++i) scene.body(scene.cell(i), physics::circle(0.2f));
}

/// Creates an explosion at each body in each step, too weak to move the body far.
void explode(CostScene& scene, int) {
    physics::FieldDefinition bang;
    bang.kind = physics::FieldKind::Explosion;
    bang.strength = 0.001f;
    for (int i = 0; i < scene.count; ++i) {
        bang.place = scene.cell(i);
        static_cast<void>(*physics::createField(scene.world, bang));
    }
}

void explosions(CostScene& scene) {
    scene.world.settings.gravity = {};
    for (int i = 0; i < scene.count; ++i) scene.body(scene.cell(i), physics::circle(0.3f));
}

void spawns(CostScene& scene) {
    // Bodies are created beside many sleeping crates, whose constant number must not add to the time.
    CostScene crowd{2000};
    restingCrates(crowd);
    scene.world = std::move(crowd.world);
    scene.world.settings.sleeping = true;
    scene.bodies.clear();
}

void sendToAndFro(CostScene& scene, int step) {
    const float speed = step % 40 < 20 ? 1.0f : -1.0f;
    for (const BodyId body : scene.bodies) {
        if (scene.world.bodies.info[body.index].kind == BodyKind::Kinematic)
            static_cast<void>(physics::setVelocity(scene.world, body, {speed, 0.0f}));
    }
}

struct CostKind {
    std::string_view name;
    int least;
    void (*build)(CostScene& scene);
    void (*drive)(CostScene& scene, int step) = nothing;
};

constexpr auto kKinds = std::to_array<CostKind>({
    {"slow balls", 500, slowBalls},
    {"fast balls", 500, fastBalls},
    {"bullets", 100, bullets},
    {"resting crates", 500, restingCrates},
    {"sleeping crates", 2000, sleepingCrates},
    {"kinematic bodies", 500, kinematicSweepers, sendToAndFro},
    {"triggers", 500, triggers},
    {"one-way platforms", 500, oneWayPlatforms},
    {"conveyors", 500, conveyors},
    {"distance joints", 500, joints<JointKind::Distance>},
    {"revolute joints", 500, joints<JointKind::Revolute>},
    {"prismatic joints", 500, joints<JointKind::Prismatic>},
    {"weld joints", 500, joints<JointKind::Weld>},
    {"wheel joints", 500, joints<JointKind::Wheel>},
    {"mouse joints", 500, joints<JointKind::Mouse>},
    {"motor joints", 500, joints<JointKind::Motor>},
    {"links of chains", 500, chainLinks},
    {"gravity areas", 50, fields<physics::FieldKind::AreaGravity>},
    {"winds", 50, fields<physics::FieldKind::Wind>},
    {"waters", 50, fields<physics::FieldKind::Buoyancy>},
    {"attractors", 50, fields<physics::FieldKind::Attractor>},
    {"endless attractors", 5, endlessAttractors},
    {"explosions a step", 50, explosions, explode},
    {"jellies", 25, jellies},
    {"spawns a step", 50, spawns, respawn},
});

/// Median time of a step, µs.
double microsOf(const CostKind& kind, int count) {
    CostScene scene{count};
    kind.build(scene);
    std::vector<double> spent;
    for (int step = 0; step < kWarmSteps + kTimedSteps; ++step) {
        const double start = wallSeconds();
        kind.drive(scene, step);
        physics::step(scene.world, kStepSeconds);
        if (step >= kWarmSteps) spent.push_back(1e6 * (wallSeconds() - start));
    }
    std::nth_element(spent.begin(), spent.begin() + std::ssize(spent) / 2, spent.end());
    return spent[spent.size() / 2];
}

}  // namespace

double CostRow::exponent() const {
    // Linear regression of the logarithms.
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    const auto n = static_cast<double>(counts.size());
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double a = std::log(static_cast<double>(counts[i])), b = std::log(micros[i]);
        x += a, y += b, xx += a * a, xy += a * b;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

std::vector<CostRow> measureCosts() {
    std::vector<CostRow> rows;
    for (const CostKind& kind : kKinds) {
        CostRow& row = rows.emplace_back();
        row.kind = kind.name;
        for (int doubling = 0; doubling < 4; ++doubling) {
            row.counts.push_back(kind.least << doubling);
            row.micros.push_back(microsOf(kind, row.counts.back()));
        }
    }
    return rows;
}

std::string textOf(std::span<const CostRow> rows) {
    std::string text;
    for (const CostRow& row : rows) {
        text += format("{}{}", row.kind, std::string(20 - std::min<std::size_t>(row.kind.size(), 19), ' '));
        for (std::size_t i = 0; i < row.counts.size(); ++i)
            text += format("  {}: {} us", row.counts[i], fixedText(row.micros[i], 1));
        text += format("  exponent {}{}\n", fixedText(row.exponent(), 2),
                       row.exponent() > kMaxExponent ? "  TOO STEEP" : "");
    }
    return text;
}

std::string markdownOf(std::span<const CostRow> rows) {
    std::string text = "| kind | counts | us a step | exponent |\n|---|---|---|---|\n";
    for (const CostRow& row : rows) {
        std::string counts, micros;
        for (std::size_t i = 0; i < row.counts.size(); ++i) {
            counts += format("{}{}", i > 0 ? " / " : "", row.counts[i]);
            micros += format("{}{}", i > 0 ? " / " : "", fixedText(row.micros[i], 1));
        }
        text += format("| {} | {} | {} | {} |\n", row.kind, counts, micros, fixedText(row.exponent(), 2));
    }
    return text;
}

}  // namespace plumb::families
