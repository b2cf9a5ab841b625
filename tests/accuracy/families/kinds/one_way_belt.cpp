// Conveyor belts with boxes and balls, and one-way platforms.
//
// Sliding friction f accelerates a box to the speed f g t until it has the belt's speed u
// after u / (f g). A ball (I = m r^2 / 2) is also rotated backwards, at twice that rate, so
// it rolls on the belt from a third of the belt's speed on, and keeps this speed. A body that
// rises completely through a platform comes to rest on it; this needs a speed of v^2 > 2 g h
// (members: by 20 %). Otherwise it falls back. A body that falls from above stays on it.

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

namespace {

constexpr float kGravity = 10.0f;  // m/s2
/// Time until a body placed on a belt presses on it with its full weight, s.
constexpr double kSettles = 0.05;

struct Good {
    std::uint32_t body = 0;
    float end = 0.0f;  // expected final speed, m/s
};

void makeBelt(Blueprint& plan, Random& random) {
    const float speed = 0.2f * std::pow(50.0f, random.unit()) * (random.below(2) == 0 ? 1.0f : -1.0f);  // m/s
    const float friction = random.between(0.1f, 1.0f), density = random.between(0.5f, 20.0f);
    const float seconds = std::fabs(speed) / (friction * kGravity);
    plan.seconds = std::min(static_cast<double>(seconds) + 0.5, 10.0);
    const float travel = std::fabs(speed) * (static_cast<float>(plan.seconds) + 1.0f);
    const int count = 1 + static_cast<int>(random.below(8));
    const float size = random.between(0.1f, 0.8f);
    const float half = travel + 3.0f * size * static_cast<float>(count);
    Material belt;
    belt.friction = friction;
    belt.surfaceSpeed = speed;
    plan.addStatic(scenes::box({half, 0.5f}), {0.0f, -0.5f}, belt);
    std::vector<Good> goods;
    for (int i = 0; i < count; ++i) {
        const bool ball = random.below(3) == 0;
        // Bodies start in a row, 2.5 sizes apart.
        const float along = 2.5f * size * (static_cast<float>(i) - 0.5f * static_cast<float>(count - 1));
        const float own = size * random.between(0.5f, 1.0f), high = own * random.between(0.3f, 0.8f);
        Material stuff{.density = density, .friction = friction};
        stuff.mask = 2;  // boxes and balls do not collide with each other
        const Outline outline = ball ? scenes::circle(own) : scenes::box({own, high});
        goods.push_back(
            {plan.addDynamic(outline, {along, ball ? own : high}, stuff), ball ? speed / 3.0f : speed});
    }
    plan.bodies[0].shapes[0].material.layers = 2;
    // At a sixth of the time that a box needs to reach the belt's speed, boxes and balls still slide.
    const int early = static_cast<int>(seconds / 6.0f / kStep);
    struct Seen {
        std::vector<double> speeds;
        double time = 0.0;
    };
    auto seen = std::make_shared<Seen>();
    plan.drive = [=](Stage& stage, int step) {
        if (step == 0) *seen = {};
        if (step != early) return;
        seen->time = stage.time();
        for (const Good& good : goods)
            seen->speeds.push_back(stage.has(good.body) ? static_cast<double>(stage.velocityOf(good.body).x)
                                                        : 0.0);
    };
    plan.goals.push_back({"gets the belt's speed",
                          [=](const Stage& stage) {
                              double worst = 0.0;
                              for (const Good& good : goods) {
                                  if (!stage.has(good.body)) continue;
                                  const float off = stage.velocityOf(good.body).x - good.end;
                                  worst = std::max(worst, static_cast<double>(std::fabs(off / good.end)));
                              }
                              return worst;
                          },
                          0.02});
    plan.goals.push_back(
        {"takes the time of friction",
         [=](const Stage& stage) {
             double worst = 0.0;
             for (std::size_t i = 0; i < seen->speeds.size(); ++i) {
                 if (!stage.has(goods[i].body)) continue;
                 const double rate = static_cast<double>(friction * kGravity);
                 // Deviation from friction * g * t, minus the speed lost while settling.
                 const double off = std::fabs(std::fabs(seen->speeds[i]) - rate * seen->time);
                 worst = std::max(worst, (off - rate * kSettles) / std::fabs(static_cast<double>(speed)));
             }
             return worst;
         },
         0.03});
}

void makePlatform(Blueprint& plan, Random& random) {
    plan.seconds = 6.0;
    const float friction = random.between(0.3f, 0.9f), density = random.between(0.5f, 20.0f);
    // Thickness of the platform and height of its top, m.
    const float thick = random.between(0.02f, 0.3f), level = random.between(2.5f, 5.0f);
    plan.addFloor({.friction = friction});
    Material gate;
    gate.friction = friction;
    gate.oneWay = true;
    const int count = 1 + static_cast<int>(random.below(8));
    plan.addStatic(scenes::box({2.0f * static_cast<float>(count), 0.5f * thick}),
                   {0.0f, level - 0.5f * thick}, gate);
    struct Jumper {
        std::uint32_t body = 0;
        float end = 0.0f;  // expected final height of the center, m
    };
    std::vector<Jumper> jumpers;
    for (int i = 0; i < count; ++i) {
        const float half = random.between(0.1f, 0.6f);
        const bool ball = random.below(2) == 0;
        const Outline outline = ball ? scenes::circle(half) : scenes::box({half, half});
        const Material stuff{.density = density, .friction = friction};
        const float x = 3.0f * (static_cast<float>(i) - 0.5f * static_cast<float>(count - 1));
        const std::uint32_t kind = random.below(3);
        // Height that the body must rise until its lower side is at the top of the platform.
        const float climb = level;
        float y = half, speed = 0.0f, end = half;
        if (kind == 0) {
            speed = std::sqrt(2.0f * kGravity * (climb * random.between(1.2f, 2.0f)));
            end = level + half;
        } else if (kind == 1) {
            // The body's upper side stays below the top of the platform, possibly inside it.
            speed = std::sqrt(2.0f * kGravity * (climb - 2.0f * half) * random.between(0.5f, 0.98f));
        } else {
            y = level + half + random.between(0.05f, 3.0f);
            end = level + half;
        }
        jumpers.push_back({plan.add({.position = {x, y}, .velocity = {0.0f, speed}}, outline, stuff), end});
    }
    plan.goals.push_back({"is where one-way platforms leave it",
                          [=](const Stage& stage) {
                              double worst = 0.0;
                              for (const Jumper& one : jumpers)
                                  if (stage.has(one.body))
                                      worst = std::max(worst, std::fabs(stage.positionOf(one.body).y -
                                                                        static_cast<double>(one.end)));
                              return worst;
                          },
                          0.02});
}

}  // namespace

Blueprint makeOneWayBelt(Random& random) {
    Blueprint plan;
    plan.closed = false;
    if (random.below(2) == 0) {
        makeBelt(plan, random);
    } else {
        makePlatform(plan, random);
    }
    return plan;
}

}  // namespace plumb::families
