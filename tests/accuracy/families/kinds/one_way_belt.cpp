// Belts that carry boxes and balls, and one-way platforms.
//
// Sliding friction m gives a box a speed of m g t until it has the belt's speed: at the latest after u /
// (m g). It also rotates a ball backwards at twice the rate at which it accelerates it (I = m r^2 / 2),
// so that a ball rolls on the belt from a third of the belt's speed on, and keeps that.
// A body that rises through a platform until all of it is above comes to rest on it, if its speed is
// high enough (v^2 > 2 g h, by 20 %); otherwise it falls back; a body that falls from above stays on it.

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

namespace {

constexpr float kGravity = 10.0f;  // m/s2
constexpr double kSettles = 0.05;  // s: until a body that was placed on a belt presses on it with its full
                                   // weight

struct Good {
    std::uint32_t body = 0;
    float end = 0.0f;  // m/s: its final speed
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
        // The faster ones in front.
        const float along = 2.5f * size * (static_cast<float>(i) - 0.5f * static_cast<float>(count - 1));
        const float own = size * random.between(0.5f, 1.0f), high = own * random.between(0.3f, 0.8f);
        Material stuff{.density = density, .friction = friction};
        stuff.mask = 2;  // they do not collide with each other
        const Outline outline = ball ? scenes::circle(own) : scenes::box({own, high});
        goods.push_back(
            {plan.addDynamic(outline, {along, ball ? own : high}, stuff), ball ? speed / 3.0f : speed});
    }
    plan.bodies[0].shapes[0].material.layers = 2;
    // Half way to the belt's speed, and to a third of it.
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
                 // Beyond what settling takes.
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
    const float thick = random.between(0.02f, 0.3f), level = random.between(2.5f, 5.0f);  // m: of its top
    plan.addFloor({.friction = friction});
    Material gate;
    gate.friction = friction;
    gate.oneWay = true;
    const int count = 1 + static_cast<int>(random.below(8));
    plan.addStatic(scenes::box({2.0f * static_cast<float>(count), 0.5f * thick}),
                   {0.0f, level - 0.5f * thick}, gate);
    struct Jumper {
        std::uint32_t body = 0;
        float end = 0.0f;  // m: height of its center at the end
    };
    std::vector<Jumper> jumpers;
    for (int i = 0; i < count; ++i) {
        const float half = random.between(0.1f, 0.6f);
        const bool ball = random.below(2) == 0;
        const Outline outline = ball ? scenes::circle(half) : scenes::box({half, half});
        const Material stuff{.density = density, .friction = friction};
        const float x = 3.0f * (static_cast<float>(i) - 0.5f * static_cast<float>(count - 1));
        const std::uint32_t kind = random.below(3);
        // From the floor to the height at which its lower side is at the top of the platform.
        const float climb = level;
        float y = half, speed = 0.0f, end = half;
        if (kind == 0) {
            speed = std::sqrt(2.0f * kGravity * (climb * random.between(1.2f, 2.0f)));
            end = level + half;
        } else if (kind == 1) {
            // Its upper side stays below the top of the platform, possibly inside it.
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
