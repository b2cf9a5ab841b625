// Sleeping bodies in a box of kinematic walls, which close until the bodies fill three quarters of the box.

#include <algorithm>
#include <cmath>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

Blueprint makeClosingBox(Random& random) {
    constexpr float kFull = 0.75f;      // ratio of the bodies' area to the final area of the box
    constexpr float kThickness = 1.0f;  // half the thickness of a wall, m
    constexpr int kAsleep = 300;        // steps until the walls start; all bodies are asleep by then
    Blueprint plan;
    plan.closed = false;
    const int count = 50 + static_cast<int>(random.below(101));
    const float radius = random.between(0.1f, 0.4f), friction = random.between(0.0f, 0.8f);
    const float speed = 0.02f * std::pow(250.0f, random.unit());  // m/s, log-uniform from 0.02 to 5
    const bool byTarget = random.below(2) == 0;
    const Material stuff{.density = random.between(0.5f, 5.0f), .friction = friction};
    const int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<float>(count))));
    const float spacing = 2.1f * radius;
    const float half = 0.5f * static_cast<float>(columns) * spacing + radius;
    const float height = 2.0f * half + 4.0f * radius;

    std::vector<std::uint32_t> crowd;
    float area = 0.0f;
    for (int i = 0; i < count; ++i) {
        const Vec2 at{(static_cast<float>(i % columns) - 0.5f * static_cast<float>(columns - 1)) * spacing,
                      radius + static_cast<float>(i / columns) * spacing};
        const bool round = random.below(2) == 0;
        const Outline outline = round ? scenes::circle(radius) : scenes::box({0.85f * radius, 0.6f * radius});
        area += round ? kPi * radius * radius : 4.0f * 0.85f * 0.6f * radius * radius;
        crowd.push_back(plan.addDynamic(outline, at, stuff));
    }
    plan.addStatic(scenes::box({half + 3.0f, kThickness}), {0.0f, -kThickness}, stuff);
    plan.addStatic(scenes::box({half + 3.0f, kThickness}), {0.0f, height + kThickness}, stuff);
    // The final width leaves room for all bodies below the ceiling.
    const float finalHalf = std::min(half, 0.5f * area / (kFull * height) + radius);
    std::vector<std::uint32_t> walls;
    for (const float side : {-1.0f, 1.0f})
        walls.push_back(
            plan.add({.motion = Motion::Kinematic, .position = {side * (half + kThickness), 0.5f * height}},
                     scenes::box({kThickness, 0.5f * height - 0.01f}), stuff));
    const int closing = static_cast<int>((half - finalHalf) / (speed * kStep)) + 1;
    plan.seconds = static_cast<double>(kStep) * (kAsleep + std::min(closing, 1200) + 60);
    plan.drive = [=](Stage& stage, int step) {
        for (int i = 0; i < 2; ++i) {
            const float side = i == 0 ? -1.0f : 1.0f;
            const bool moves = step >= kAsleep && step < kAsleep + closing;
            const float way = speed * kStep * static_cast<float>(std::clamp(step - kAsleep + 1, 0, closing));
            const std::uint32_t wall = walls[static_cast<std::size_t>(i)];
            if (!byTarget) {
                stage.setVelocity(wall, {moves ? -side * speed : 0.0f, 0.0f});
            } else if (moves) {
                stage.moveTo(wall, {side * (half + kThickness - way), 0.5f * height}, 0.0f);
            }
        }
    };
    plan.goals.push_back(staysIn(crowd, {-half, 0.0f}, {half, height}));
    plan.goals.push_back({"is pushed, not passed through",
                          [=](const Stage& stage) {
                              // Counts body centers behind the inner face of a wall.
                              double behind = 0.0;
                              for (const std::uint32_t body : crowd) {
                                  if (!stage.has(body) || !stage.has(walls[0]) || !stage.has(walls[1]))
                                      continue;
                                  const double x = stage.positionOf(body).x;
                                  const double low =
                                      stage.positionOf(walls[0]).x + static_cast<double>(kThickness);
                                  const double high =
                                      stage.positionOf(walls[1]).x - static_cast<double>(kThickness);
                                  behind += x < low || x > high ? 1.0 : 0.0;
                              }
                              return behind;
                          },
                          0.0});
    return plan;
}

}  // namespace plumb::families
