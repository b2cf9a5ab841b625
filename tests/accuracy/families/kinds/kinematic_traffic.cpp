// Kinematic bodies that hit sleeping and awake bodies: a lift that carries
// crates, a sweeper in a corridor, a rotor in a room, a piston in a cylinder.
//
// Crates must stay on a lift: its position is a cosine of time with accelerations below
// 0.4 friction g horizontally and 0.5 g vertically, and crates are no higher than wide, so
// that they do not tip over (friction at most 0.8). Bodies hit by a sweeper, rotor or
// piston have room to move aside: the corridor is open at its end, the gap between rotor
// and walls is 2.5 times the size of the largest crate, the cylinder is at most 60 % full.

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

namespace {

constexpr float kGravity = 10.0f;  // m/s2
constexpr int kAsleep = 75;        // steps until the first motion; all bodies are asleep by then
constexpr int kWakes = 2;          // steps of the lift's motion after which a carried body must be awake

/// A kinematic body that moves back and forth between two points, with rests at both ends.
struct Shuttle {
    std::uint32_t body = 0;
    Vec2 start;
    Vec2 stroke;          // displacement from one end to the other, m
    int rests = kAsleep;  // number of steps of a rest at each end
    int moves = 60;       // number of steps of a move from end to end
    bool byTarget = true;
    bool even = false;  ///< true: constant speed; false: cosine of time

    [[nodiscard]] bool isMoving(int step) const { return step % (rests + moves) >= rests; }
    /// Returns the target position at the end of a step.
    [[nodiscard]] Vec2 at(int step) const {
        const int cycle = step / (rests + moves), phase = step % (rests + moves) - rests + 1;
        float part = 0.0f;
        if (phase > 0) part = static_cast<float>(phase) / static_cast<float>(moves);
        if (!even) part = 0.5f - 0.5f * std::cos(kPi * part);
        if (cycle % 2 == 1) part = 1.0f - part;
        return start + part * stroke;
    }
    void drive(Stage& stage, int step) const {
        const Vec2 before = step == 0 ? start : at(step - 1), next = at(step);
        if (byTarget) {
            if (isMoving(step)) stage.moveTo(body, next, 0.0f);
        } else {
            stage.setVelocity(body, (1.0f / kStep) * (next - before));
        }
    }
};

struct Watch {
    double asleep = 0.0;  // number of bodies asleep while the lift moves them, summed over all steps
};

Goal staysAwake(const std::shared_ptr<Watch>& watch) {
    return {"is awake while it is moved", [watch](const Stage&) { return watch->asleep; }, 0.0};
}

void makeLift(Blueprint& plan, Random& random) {
    const float friction = random.between(0.2f, 0.8f), half = random.between(0.5f, 4.0f);
    const bool upright = random.below(2) == 0;
    const Material stuff{.density = random.between(0.5f, 10.0f), .friction = friction};
    Shuttle lift;
    lift.start = {0.0f, 5.0f};
    const float speed = 0.01f * std::pow(500.0f, random.unit());  // maximum speed, m/s
    // A cosine over A meters in T seconds has a maximum speed of A pi / 2T and acceleration of A pi^2 / 2T^2.
    const float bound = upright ? 0.5f * kGravity : 0.4f * friction * kGravity;
    const float seconds = std::max(0.5f, kPi * speed / bound) * random.between(1.0f, 2.0f);
    const float length = speed * seconds * 2.0f / kPi;
    lift.stroke = upright ? Vec2{0.0f, length} : Vec2{length, 0.0f};
    lift.moves = std::max(static_cast<int>(seconds / kStep), 20);
    lift.rests = random.below(2) == 0 ? kAsleep : 10;
    lift.byTarget = random.below(2) == 0;
    plan.seconds = std::min(static_cast<double>(kStep) * 3.0 * (lift.rests + lift.moves), 10.0);
    lift.body =
        plan.add({.motion = Motion::Kinematic, .position = lift.start}, scenes::box({half, 0.2f}), stuff);
    std::vector<std::uint32_t> crates;
    const int columns = 1 + static_cast<int>(random.below(3)), rows = 1 + static_cast<int>(random.below(3));
    const float size = 0.4f * half / static_cast<float>(columns);
    for (int i = 0; i < columns * rows; ++i)
        crates.push_back(plan.addDynamic(
            scenes::box({size, 0.8f * size}),
            lift.start +
                Vec2{(static_cast<float>(i % columns) - 0.5f * static_cast<float>(columns - 1)) * 2.4f * size,
                     0.2f + 0.8f * size + 1.6f * size * static_cast<float>(i / columns)},
            stuff));
    auto watch = std::make_shared<Watch>();
    plan.drive = [=](Stage& stage, int step) {
        if (step == 0) *watch = {};
        // Counts bodies that are still asleep kWakes steps after the motion began.
        if (stage.has(lift.body) && step > kWakes && lift.isMoving(step - 1) &&
            lift.isMoving(step - 1 - kWakes))
            for (const std::uint32_t crate : crates)
                watch->asleep += stage.has(crate) && stage.isAsleep(crate) ? 1.0 : 0.0;
        lift.drive(stage, step);
    };
    plan.goals.push_back(
        {"stays on the lift",
         [=](const Stage& stage) {
             double furthest = 0.0;
             for (const std::uint32_t crate : crates) {
                 if (!stage.has(crate) || !stage.has(lift.body)) continue;
                 const scenes::Point at = stage.positionOf(crate), on = stage.positionOf(lift.body);
                 const Vec2 planned = stage.startOf(crate) - lift.start;
                 furthest = std::max(furthest, std::hypot(at.x - on.x - static_cast<double>(planned.x),
                                                          at.y - on.y - static_cast<double>(planned.y)));
             }
             return furthest;
         },
         0.05});
    plan.goals.push_back(staysAwake(watch));
}

Outline crateOf(Random& random, float size) {
    return random.below(2) == 0 ? scenes::circle(size) : scenes::box({0.8f * size, 0.6f * size});
}

/// Adds a sweeper in a corridor with a ceiling, or a piston in a closed cylinder.
void makeSweeper(Blueprint& plan, Random& random, bool piston) {
    const Material stuff{.density = random.between(0.5f, 10.0f), .friction = random.between(0.0f, 0.8f)};
    const float size = random.between(0.1f, 0.4f), height = size * random.between(3.0f, 8.0f);
    const int count = 3 + static_cast<int>(random.below(28));
    const int rows = std::max(static_cast<int>(height / (2.2f * size)), 1);
    const float room = 2.2f * size * (static_cast<float>((count + rows - 1) / rows) + 1.0f);  // m
    const float speed = 0.01f * std::pow(2000.0f, random.unit());                             // m/s
    const float end = piston ? 2.0f * room : 1000.0f;
    plan.addStatic(scenes::box({500.0f, 0.5f}), {490.0f, -0.5f}, stuff);
    plan.addStatic(scenes::box({500.0f, 0.5f}), {490.0f, height + 0.5f}, stuff);
    if (piston) plan.addStatic(scenes::box({0.5f, height}), {end + 0.5f, 0.5f * height}, stuff);
    std::vector<std::uint32_t> crowd;
    float area = 0.0f;
    for (int i = 0; i < count; ++i) {
        const float own = size * random.between(0.6f, 1.0f);
        crowd.push_back(plan.addDynamic(crateOf(random, own),
                                        {2.2f * size * (static_cast<float>(i / rows) + 0.6f),
                                         size * (1.0f + 2.2f * static_cast<float>(i % rows))},
                                        stuff));
        area += kPi * own * own;
    }
    Shuttle pusher;
    const float thick = 0.02f * std::pow(50.0f, random.unit());  // half the thickness, m
    pusher.start = {-1.0f - thick, 0.5f * height};
    const float free = piston ? end - area / (0.6f * height) : random.between(0.5f, 1.5f) * room;
    float stroke = std::max(free, 0.2f) + 1.0f;
    // The stroke is limited by time and speed.
    pusher.even = random.below(2) == 0;
    const float highest = pusher.even ? 1.0f : 0.5f * kPi;  // ratio of maximum to mean speed
    const float seconds = std::min(highest * stroke / speed, piston ? 2.0f : 5.0f);
    stroke = std::min(stroke, speed * seconds / highest);
    // A short stroke starts at the first body.
    pusher.start.x = std::max(-1.0f, -0.5f * stroke) - thick;
    stroke = std::min(stroke, free - thick - pusher.start.x);
    pusher.stroke = {stroke, 0.0f};
    pusher.moves = std::max(static_cast<int>(seconds / kStep), 4);
    pusher.rests = piston && random.below(2) == 0 ? 5 : kAsleep;
    pusher.byTarget = random.below(2) == 0;
    pusher.body = plan.add({.motion = Motion::Kinematic, .position = pusher.start},
                           scenes::box({thick, 0.5f * height - 0.01f}), stuff);
    const int strokes = piston ? 4 : 1;
    plan.seconds = std::min(static_cast<double>(kStep) * strokes * (pusher.rests + pusher.moves), 8.0);
    plan.drive = [=](Stage& stage, int step) { pusher.drive(stage, step); };
    plan.goals.push_back({"is pushed, not passed through",
                          [=](const Stage& stage) {
                              double behind = 0.0;
                              for (const std::uint32_t body : crowd) {
                                  if (!stage.has(body) || !stage.has(pusher.body)) continue;
                                  const double x = stage.positionOf(body).x;
                                  const bool ahead =
                                      x >= stage.positionOf(pusher.body).x + static_cast<double>(thick);
                                  behind += ahead && x <= static_cast<double>(end) ? 0.0 : 1.0;
                              }
                              return behind;
                          },
                          0.0});
    plan.goals.push_back(overlapsAtMost(0.05));
}

/// Adds a rotor in a room seen from above: no gravity, crates with drag.
void makeRotor(Blueprint& plan, Random& random) {
    plan.gravity = {};
    plan.seconds = 5.0;
    const Material stuff{.density = random.between(0.5f, 10.0f), .friction = random.between(0.0f, 0.8f)};
    const float size = random.between(0.1f, 0.4f), reach = random.between(1.5f, 4.0f);
    const float half = reach + 5.0f * size, thick = random.between(0.05f, 0.3f);
    // Angular velocity, rad/s, for a tip speed of 0.01 to 20 m/s.
    const float spin =
        0.01f * std::pow(2000.0f, random.unit()) / reach * (random.below(2) == 0 ? 1.0f : -1.0f);
    for (const float side : {-1.0f, 1.0f}) {
        plan.addStatic(scenes::box({0.5f, half + 1.0f}), {side * (half + 0.5f), 0.0f}, stuff);
        plan.addStatic(scenes::box({half + 1.0f, 0.5f}), {0.0f, side * (half + 0.5f)}, stuff);
    }
    const std::uint32_t rotor = plan.add({.motion = Motion::Kinematic}, scenes::box({reach, thick}), stuff);
    std::vector<std::uint32_t> crowd;
    const int count = 4 + static_cast<int>(random.below(13));
    for (int i = 0; i < count; ++i) {
        // Crates lie around the hub on both sides of the rotor,
        // clear of each other and of its initial position.
        const float angle = kPi * (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
        const float out = reach * 0.75f;
        const float room = 0.45f * out * kPi / static_cast<float>(count);
        const float own = std::min(size * random.between(0.6f, 1.0f), room);
        const float low = std::max(out * std::sin(angle), thick + own + 0.02f);
        const Vec2 at{out * std::cos(angle), i % 2 == 0 ? low : -low};
        BodySetup setup;
        setup.position = at;
        setup.drag = 1.0f;
        crowd.push_back(plan.add(setup, crateOf(random, own), stuff));
    }
    plan.drive = [=](Stage& stage, int step) { stage.setSpin(rotor, step >= kAsleep ? spin : 0.0f); };
    // After half a revolution the rotor has swept the whole circle.
    const float turned = std::fabs(spin) * (static_cast<float>(plan.seconds) - kAsleep * kStep);
    if (turned > kPi)
        plan.goals.push_back({"is hit by the rotor",
                              [=](const Stage& stage) {
                                  double missed = 0.0;
                                  for (const std::uint32_t body : crowd)
                                      missed +=
                                          stage.has(body) && stage.displacementOf(body) < 0.01 ? 1.0 : 0.0;
                                  return missed;
                              },
                              0.0});
    plan.goals.push_back(staysIn(crowd, {-half, -half}, {half, half}));
    plan.goals.push_back(overlapsAtMost(0.05));
    plan.goals.push_back(
        {"nothing is inside the rotor",
         [=](const Stage& stage) {
             double inside = 0.0;
             if (!stage.has(rotor)) return inside;
             const Rot rotation = stage.rotationOf(rotor);
             const scenes::Point hub = stage.positionOf(rotor);
             for (const std::uint32_t body : crowd) {
                 if (!stage.has(body)) continue;
                 const scenes::Point at = stage.positionOf(body);
                 const Vec2 local =
                     unrotate(rotation, {static_cast<float>(at.x - hub.x), static_cast<float>(at.y - hub.y)});
                 inside += std::fabs(local.x) < reach && std::fabs(local.y) < thick ? 1.0 : 0.0;
             }
             return inside;
         },
         0.0});
}

}  // namespace

Blueprint makeKinematicTraffic(Random& random) {
    Blueprint plan;
    plan.closed = false;
    switch (random.below(4)) {
        case 0: makeLift(plan, random); break;
        case 1: makeSweeper(plan, random, false); break;
        case 2: makeSweeper(plan, random, true); break;
        default: makeRotor(plan, random);
    }
    return plan;
}

}  // namespace plumb::families
