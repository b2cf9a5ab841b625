// Bullets fired in a room at its walls, at rotating plates and at crates.
//
// Every dynamic body must stay in its room: the walls are static and reach from floor to ceiling. The gap
// between a rotating plate and any wall is wider than the largest crate, so that no crate is crushed.

#include <algorithm>
#include <cmath>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

Blueprint makeBullets(Random& random) {
    constexpr float kCrate = 0.5f;  // upper limit of half the diagonal of a crate, m
    Blueprint plan;
    plan.seconds = 4.0;
    if (random.below(2) == 0) plan.gravity = {};
    const int rooms = 1 + static_cast<int>(random.below(3));
    const float width = random.between(6.0f, 14.0f), height = random.between(6.0f, 10.0f);  // of a room, m
    const float wall = random.between(0.025f, 0.25f);            // half the thickness of a wall, m
    const float speed = 10.0f * std::pow(30.0f, random.unit());  // initial speed of the bullets, m/s
    const float caliber = random.between(0.03f, 0.15f), weight = random.between(1.0f, 20.0f);
    const bool spins = random.below(2) == 0;
    const float spin = random.between(-8.0f, 8.0f);
    const Material stuff{.friction = random.between(0.0f, 0.8f), .bounciness = random.between(0.0f, 0.8f)};
    Material lead = stuff;
    lead.density = weight;
    const float all = static_cast<float>(rooms) * width;
    plan.addStatic(scenes::box({0.5f * all + 1.0f, wall}), {0.5f * all, -wall}, stuff);
    plan.addStatic(scenes::box({0.5f * all + 1.0f, wall}), {0.5f * all, height + wall}, stuff);
    for (int i = 0; i <= rooms; ++i)
        plan.addStatic(scenes::box({wall, 0.5f * height}), {static_cast<float>(i) * width, 0.5f * height},
                       stuff);

    for (int room = 0; room < rooms; ++room) {
        const float left = static_cast<float>(room) * width, right = left + width;
        const Vec2 middle{left + 0.5f * width, 0.5f * height};
        std::vector<std::uint32_t> inside;
        // A plate that rotates about the center of the room: on a hinge, or kinematic.
        const float reach = random.between(0.4f, 0.5f * std::min(width, height) - 2.0f * kCrate - 0.5f);
        if (spins) {
            plan.add({.motion = Motion::Kinematic, .position = middle, .spin = spin},
                     scenes::box({reach, random.between(0.03f, 0.1f)}), stuff);
            plan.closed = false;
        } else {
            const std::uint32_t plate =
                plan.addDynamic(scenes::box({reach, random.between(0.03f, 0.1f)}), middle, lead);
            plan.join(plan.addAnchor(middle), plate, middle);
            inside.push_back(plate);
        }
        const int crates = static_cast<int>(random.below(4)), bullets = 2 + static_cast<int>(random.below(7));
        for (int i = 0; i < crates; ++i) {
            const float half = random.between(0.1f, 0.7f * kCrate);
            inside.push_back(plan.addDynamic(
                scenes::box({half, half}),
                {left + 1.0f + (width - 2.0f) * (static_cast<float>(i) + 0.5f) / static_cast<float>(crates),
                 kCrate},
                stuff));
        }
        for (int i = 0; i < bullets; ++i) {
            // Bullets start in a column along the left wall, with random directions to the right.
            const float heading = random.between(-1.2f, 1.2f);
            const bool round = random.below(2) == 0;
            const float y = height * (static_cast<float>(i) + 1.0f) / static_cast<float>(bullets + 1);
            inside.push_back(plan.add(
                {.position = {left + wall + 0.3f, y},
                 .angle = heading,
                 .velocity = {speed * std::cos(heading), speed * std::sin(heading)},
                 .bullet = true},
                round ? scenes::circle(caliber) : scenes::box({1.5f * caliber, 0.6f * caliber}), lead));
        }
        plan.goals.push_back(staysIn(inside, {left, 0.0f}, {right, height}));
    }
    // Bodies that approach at 6 m/s may overlap by 0.1 m at the end of the step in which they collide.
    plan.goals.push_back(overlapsAtMost(0.1));
    return plan;
}

}  // namespace plumb::families
