// Family "fields": planets with gravity, water, and linear attractors.
//
// Planet with an acceleration k / d^2 at distance d: a falling body comes to rest on the ground or others; a
// moon at distance d with a tangential speed of sqrt(k / d) keeps this distance. Water: a box of height h and
// density ratio s < 1 floats with s h under water (Archimedes). A box at least 1.5 times as wide as high does
// not capsize: its metacenter is above the center of mass if width^2 / height^2 > 6 s (1 - s), whose maximum
// is 1.5. Damped by more than 1/s it is at rest after 10 s. A denser box lies on the ground. Linear attractor
// with constant k: positions oscillate as cos(sqrt(k) t) in x and y.

#include "physics/model/fields.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

namespace {

/// Result of the creation of a field in one run.
struct FieldState {
    std::string refused;  ///< error message; empty: created
};

void addField(Blueprint& plan, const physics::FieldDefinition& field, Vec2 place) {
    auto state = std::make_shared<FieldState>();
    plan.extraNeeds = "fields";
    plan.extra = [=](Stage& stage) {
        *state = {};
        physics::FieldDefinition made = field;
        made.place = stage.placeOf(place);
        made.length *= stage.scale();
        // The strength of an inverse-square attractor has the unit m3/s2, so it scales with the cube of
        // lengths; that of a linear one is in 1/s2.
        if (field.kind == physics::FieldKind::Attractor && !field.linear)
            made.strength *= stage.scale() * stage.scale() * stage.scale();
        const auto id = physics::createField(*stage.world(), made);
        if (!id) state->refused = id.error().text();
    };
    plan.goals.push_back({"is built", [=](const Stage&) { return state->refused.empty() ? 0.0 : 1.0; }, 0.0});
}

void makePlanet(Blueprint& plan, Random& random) {
    plan.gravity = {};
    plan.closed = false;  // energyOf() does not include the potential energy of attractors
    plan.seconds = 10.0;
    const float radius = random.between(1.0f, 6.0f), surface = random.between(3.0f, 20.0f);  // m, m/s2
    const float pull = surface * radius * radius;
    const Material stuff{.density = random.between(0.5f, 10.0f), .friction = random.between(0.3f, 0.9f)};
    addField(plan, {.kind = physics::FieldKind::Attractor, .strength = pull}, {});
    plan.addStatic(scenes::circle(radius), {}, stuff);
    const int count = 4 + static_cast<int>(random.below(21));
    const float size = random.between(0.1f, 0.3f);
    std::vector<std::uint32_t> landers;
    for (int i = 0; i < count; ++i) {
        // Landers (bodies that fall on the planet) start in rings around it, apart from each other.
        const int around = std::max(static_cast<int>(kTau * radius / (3.0f * size)), 4);
        const float angle =
            kTau * (static_cast<float>(i % around) + random.between(0.0f, 0.2f)) / static_cast<float>(around);
        const float out =
            radius + size * (2.0f + 3.0f * static_cast<float>(i / around)) + random.between(0.0f, 0.5f);
        const bool round = random.below(3) == 0;
        const Outline outline = round ? scenes::circle(size) : scenes::box({0.8f * size, 0.6f * size});
        landers.push_back(plan.addDynamic(outline, out * Vec2{std::cos(angle), std::sin(angle)}, stuff,
                                          random.between(0.0f, kTau)));
    }
    // Moons, which do not collide.
    std::vector<std::uint32_t> moons;
    Material stone = stuff;
    stone.mask = 0;
    for (std::uint32_t i = 0; i < random.below(4); ++i) {
        const float out = radius * random.between(2.0f, 6.0f) + 3.0f, angle = random.between(0.0f, kTau);
        const Vec2 direction{std::cos(angle), std::sin(angle)};
        moons.push_back(plan.add({.position = out * direction,
                                  .velocity = std::sqrt(pull / out) * Vec2{-direction.y, direction.x}},
                                 scenes::circle(size), stone));
    }
    plan.goals.push_back({"lies on the planet",
                          [=](const Stage& stage) {
                              // Maximum height of a lander above the ground, m.
                              double furthest = 0.0;
                              for (const std::uint32_t body : landers) {
                                  if (!stage.has(body)) continue;
                                  const scenes::Point at = stage.positionOf(body);
                                  const double above = std::hypot(at.x, at.y) - static_cast<double>(radius);
                                  furthest = std::max({furthest, above, above < 0.0 ? 1e3 : 0.0});
                              }
                              return furthest;
                          },
                          2.0 * static_cast<double>(size) * count});
    plan.goals.push_back(overlapsAtMost(0.02));
    plan.goals.push_back(
        {"keeps its orbit",
         [=](const Stage& stage) {
             double worst = 0.0;
             for (const std::uint32_t body : moons) {
                 if (!stage.has(body)) continue;
                 const scenes::Point at = stage.positionOf(body);
                 const Vec2 start = stage.startOf(body);
                 worst = std::max(
                     worst, std::fabs(std::hypot(at.x, at.y) / static_cast<double>(length(start)) - 1.0));
             }
             return worst;
         },
         0.02});
}

void makeWater(Blueprint& plan, Random& random) {
    constexpr float kDeep = 6.0f;  // depth of the water, m
    plan.seconds = 10.0;
    physics::FieldDefinition water;
    water.kind = physics::FieldKind::Buoyancy;
    water.density = random.between(0.5f, 5.0f);
    water.linearDrag = random.between(2.0f, 5.0f);
    water.angularDrag = random.between(2.0f, 5.0f);
    addField(plan, water, {});
    plan.closed = false;  // energyOf() does not include buoyancy
    plan.addStatic(scenes::box({100.0f, 1.0f}), {0.0f, -kDeep - 1.0f}, {});
    struct Floater {
        std::uint32_t body = 0;
        float y = 0.0f;       // height of the center while floating, m
        float height = 0.0f;  // height of the box, m
    };
    std::vector<Floater> floaters;
    const int count = 1 + static_cast<int>(random.below(12));
    float edge = 0.0f;
    for (int i = 0; i < count; ++i) {
        const float height = random.between(0.1f, 1.5f), width = height * random.between(1.5f, 4.0f);
        const bool sinks = random.below(5) == 0;
        const float part = sinks ? random.between(1.3f, 8.0f) : random.between(0.1f, 0.9f);
        const float y = sinks ? -kDeep + 0.5f * height : (0.5f - part) * height;
        edge += 0.5f * width + 0.5f;
        const float drop = random.between(-0.5f, 0.5f) * height;
        floaters.push_back(
            {plan.addDynamic(scenes::box({0.5f * width, 0.5f * height}), {edge, (sinks ? 0.0f : y) + drop},
                             {.density = part * water.density}, random.between(-0.1f, 0.1f)),
             y, height});
        edge += 0.5f * width + 0.5f;
    }
    plan.goals.push_back({"floats as Archimedes says",
                          [=](const Stage& stage) {
                              double worst = 0.0;
                              for (const Floater& one : floaters) {
                                  if (!stage.has(one.body)) continue;
                                  const double off =
                                      stage.positionOf(one.body).y - static_cast<double>(one.y);
                                  worst = std::max(worst, std::fabs(off) / static_cast<double>(one.height));
                              }
                              return worst;
                          },
                          0.02});
    plan.goals.push_back({"lies level",
                          [=](const Stage& stage) {
                              double worst = 0.0;
                              for (const Floater& one : floaters) {
                                  if (!stage.has(one.body)) continue;
                                  const Rot rotation = stage.rotationOf(one.body);
                                  worst = std::max(worst, static_cast<double>(std::fabs(angleOf(rotation))));
                              }
                              return worst;
                          },
                          0.05});
}

void makeSwing(Blueprint& plan, Random& random) {
    plan.gravity = {};
    plan.seconds = 5.0;
    const float strength = std::pow(36.0f, random.unit());  // 1/s2
    // In substeps of h the energy of an oscillation of angular
    // frequency w fluctuates by w h / 2: 0.4 % at w = 2/s.
    plan.closed = strength < 4.0f;
    addField(plan, {.kind = physics::FieldKind::Attractor, .linear = true, .strength = strength}, {});
    Material air;
    air.mask = 0;
    air.density = random.between(0.1f, 20.0f);
    const int count = 1 + static_cast<int>(random.below(20));
    std::vector<std::uint32_t> all;
    for (int i = 0; i < count; ++i)
        all.push_back(plan.add({.position = {random.between(-20.0f, 20.0f), random.between(-20.0f, 20.0f)},
                                .velocity = {random.between(-5.0f, 5.0f), random.between(-5.0f, 5.0f)},
                                .spin = random.between(-3.0f, 3.0f)},
                               scenes::box({random.between(0.1f, 1.0f), random.between(0.1f, 1.0f)}), air));
    plan.goals.push_back({"swings by the formula",
                          [=](const Stage& stage) {
                              double worst = 0.0;
                              const double rate = std::sqrt(static_cast<double>(strength));
                              const double cos = std::cos(rate * stage.time()),
                                           sin = std::sin(rate * stage.time());
                              for (const std::uint32_t body : all) {
                                  if (!stage.has(body)) continue;
                                  const BodySetup& setup = stage.plan().bodies[body].setup;
                                  if (setup.motion == Motion::Static) continue;
                                  const auto x = static_cast<double>(setup.position.x),
                                             y = static_cast<double>(setup.position.y),
                                             u = static_cast<double>(setup.velocity.x) / rate,
                                             v = static_cast<double>(setup.velocity.y) / rate;
                                  const scenes::Point at = stage.positionOf(body);
                                  const double off =
                                      std::hypot(at.x - x * cos - u * sin, at.y - y * cos - v * sin);
                                  worst = std::max(worst, off / std::hypot(x, y, std::hypot(u, v)));
                              }
                              return worst;
                          },
                          0.02});
}

}  // namespace

Blueprint makeFields(Random& random) {
    Blueprint plan;
    switch (random.below(3)) {
        case 0: makePlanet(plan, random); break;
        case 1: makeWater(plan, random); break;
        default: makeSwing(plan, random);
    }
    return plan;
}

}  // namespace plumb::families
