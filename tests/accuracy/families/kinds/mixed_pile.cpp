// Balls, boxes, polygons, thin and tiny bodies that fall into a pit.
//
// Restitution is 0, so bodies that fall at most 10 m lose their speed in the first impacts, and friction
// stops sliding and tipping. Balls would roll on, so they have a drag of 2/s, which reduces the speed of a
// rolling ball at 2/3 of this rate, to below 1/1000 in 10 s. At rest two shapes may overlap by the slop (5
// mm), and at the bottom by another 5 mm of contact compliance under the weight.

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

namespace {

/// Creates a polygon of 3 to 8 corners on an ellipse, whose spacing is at least half of the regular one.
Outline polygonOf(Random& random, Vec2 half) {
    std::array<Vec2, 8> corners{};
    const std::size_t count = 3 + random.below(6);
    for (std::size_t i = 0; i < count; ++i) {
        const float angle =
            kTau * (static_cast<float>(i) + random.between(0.0f, 0.5f)) / static_cast<float>(count);
        corners[i] = {half.x * cosine(angle), half.y * sine(angle)};
    }
    return scenes::polygon({corners.data(), count});
}

}  // namespace

Blueprint makeMixedPile(Random& random) {
    Blueprint plan;
    plan.seconds = 12.0;
    const int count = 15 + static_cast<int>(random.below(22));
    const float size = random.between(0.3f, 0.8f);        // half the length of the largest body, m
    const float crumb = std::pow(20.0f, -random.unit());  // size ratio of the smallest to the largest body
    const float slim = std::pow(20.0f, -random.unit());   // ratio of thickness to length of the thinnest body
    const float spread = random.unit();                   // log10 of the maximum density ratio
    const Material stuff{.friction = random.between(0.2f, 0.9f)};
    const float half = size * random.between(3.0f, 6.0f);  // half the width of the pit, m
    constexpr float kWall = 1.0f;                          // half the thickness of a wall, m
    const float height = 6.0f * half;

    std::vector<std::uint32_t> bodies;
    const int columns = std::max(1, static_cast<int>(half / (1.05f * size)));
    const float pitch = 2.1f * size;
    for (int i = 0; i < count; ++i) {
        const float own = size * std::pow(crumb, random.unit());
        const float aspect = std::max(std::pow(slim, random.unit()), 0.0125f / own);
        const Vec2 at{(static_cast<float>(i % columns) - 0.5f * static_cast<float>(columns - 1)) * pitch,
                      size + static_cast<float>(i / columns) * pitch};
        Material material = stuff;
        material.density = 2.0f * std::pow(10.0f, spread * random.unit());
        BodySetup setup{.position = at, .angle = random.between(-kPi, kPi)};
        Outline outline;
        switch (random.below(4)) {
            case 0:
                outline = scenes::circle(own);
                setup.drag = 2.0f;
                break;
            case 1: outline = scenes::box({0.7f * own, 0.7f * own * aspect}); break;
            default: outline = polygonOf(random, {own, std::max(own * aspect, 0.0125f)});
        }
        bodies.push_back(plan.add(setup, outline, material));
    }
    plan.addStatic(scenes::box({half + 2.0f * kWall, kWall}), {0.0f, -kWall}, stuff);
    for (const float side : {-1.0f, 1.0f})
        plan.addStatic(scenes::box({kWall, 0.5f * height}), {side * (half + kWall), 0.5f * height}, stuff);
    plan.goals.push_back(staysIn(bodies, {-half, 0.0f}, {half, height}));
    plan.goals.push_back(rests(bodies, 0.05));
    plan.goals.push_back(overlapsAtMost(0.01));
    return plan;
}

}  // namespace plumb::families
