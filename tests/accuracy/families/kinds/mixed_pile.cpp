// A pile of balls, boxes, polygons, slivers and crumbs that falls in a pit.
//
// Nothing bounces, so what falls 10 m at most, in a second and a half, loses its speed in the first hits, and
// friction stops what slides and tips. A ball on a level floor would roll on: what is round has a drag of
// 2/s, which takes a rolling ball's speed by two thirds of that, to below a thousandth in 10 s. At rest two
// shapes may overlap by the slop, 5 mm, and by what the weight on it presses a soft contact: as much again at
// the bottom.

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

namespace {

/// 3 to 8 corners on an ellipse, no two nearer than half of their even distance.
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
    const float size = random.between(0.3f, 0.8f);        // m: half of the largest
    const float crumb = std::pow(20.0f, -random.unit());  // the smallest over the largest
    const float slim = std::pow(20.0f, -random.unit());   // the thinnest sliver over its length
    const float spread = random.unit();                   // of the logarithm of densities, up to 10
    const Material stuff{.friction = random.between(0.2f, 0.9f)};
    const float half = size * random.between(3.0f, 6.0f);  // m: of the pit
    constexpr float kWall = 1.0f;                          // m: half of its thickness
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
