#include <algorithm>
#include <cmath>

#include "tests/physics/support/world_of_bodies.hpp"

namespace plumb::physics {
namespace {

World worldWithFloor(bool isChain) {
    World world;
    world.settings.gravity = {0.0f, -10.0f};
    const BodyId floor = addBody(world, BodyKind::Static, {});
    if (isChain) {
        const std::array<Vec2, 4> points{Vec2{30.0f, 0.0f}, {20.0f, 0.0f}, {-20.0f, 0.0f}, {-30.0f, 0.0f}};
        static_cast<void>(createChain(world, floor, points, false));
    } else {
        static_cast<void>(createShape(world, floor, box({20.0f, 5.0f}, {0.0f, -5.0f})));
    }
    return world;
}

/// Adds a crowd that falls into a funnel with a bottom two sizes (m) wide, below walls that no body leaves.
std::vector<BodyId> fillFunnel(World& world, Random& random, float size) {
    std::vector<Vec2> points;
    for (const float side : {1.0f, -1.0f}) {
        std::array half{Vec2{20.0f * side, 4001.0f}, Vec2{20.0f * side, 4000.0f}, Vec2{20.0f * side, 40.0f},
                        Vec2{side, 0.0f}};
        if (side < 0.0f) std::reverse(half.begin(), half.end());
        for (const Vec2 corner : half) points.push_back(size * corner);
    }
    static_cast<void>(createChain(world, addBody(world, BodyKind::Static, {}), points, false));
    std::vector<BodyId> crowd;
    for (int n = 0; n < 50; ++n) {
        const int column = n % 8, row = n / 8;
        crowd.push_back(addBody(world, BodyKind::Dynamic, {0.9 * size * (column - 3.5), size * (10.0 + row)},
                                random.between(0.0f, 6.0f)));
        addRandomShape(world, crowd.back(), random, size * random.between(0.1f, 0.45f));
        static_cast<void>(
            setVelocity(world, crowd.back(), {random.between(-3.0f, 3.0f), -random.between(3.0f, 50.0f)}));
    }
    return crowd;
}

int countBelowFunnel(const World& world, const std::vector<BodyId>& crowd, float size) {
    return static_cast<int>(std::count_if(crowd.begin(), crowd.end(), [&](BodyId body) {
        const WorldPosition centre = centreOf(world, body);
        return centre.y < std::max(std::fabs(centre.x) - size, 0.0) * (40.0 / 19.0);
    }));
}

}  // namespace

// The spring of a contact yields in proportion to the load: thousands of times the mass of a small body would
// press it through.
TEST(PressedBodies, stayAboveAStaticFloorUnderAnyLoad) {
    Random random = Random::seeded(41);
    int pressed = 0;
    for (int i = 0; i < 60; ++i) {
        World world = worldWithFloor(i % 2 == 0);
        world.settings.quality = static_cast<std::uint8_t>(1 + i % 4);
        const float radius = 0.03f * std::pow(16.0f, random.between(0.0f, 1.0f));  // 3 to 50 cm
        const float ratio = 10.0f * std::pow(300.0f, random.between(0.0f, 1.0f));  // 10 to 3,000
        const BodyId small = addBody(world, BodyKind::Dynamic, {0.0, radius});
        addRandomShape(world, small, random, radius);
        const BodyId load = *createBody(world, {.position = {0.0, 3.1 * radius}, .fixedRotation = true});
        static_cast<void>(createShape(world, load, box({4.0f * radius, radius})));
        static_cast<void>(setMass(world, load, massOf(world, small) * ratio));
        double lowest = radius;  // m
        for (int n = 0; n < 300; ++n) {
            step(world, kTick);
            lowest = std::min(lowest, centreOf(world, small).y);
        }
        EXPECT_GT(lowest, 0.0) << "radius " << radius << " m, load " << ratio << " times the mass, quality "
                               << int{world.settings.quality};
        if (lowest < 0.7 * radius) ++pressed;
    }
    EXPECT_GT(pressed, 10);
}

TEST(PressedBodies, stayInAFunnelUnderACrowd) {
    Random random = Random::seeded(42);
    for (int i = 0; i < 12; ++i) {
        World world;
        world.settings.gravity = {0.0f, -10.0f};
        const float size = 0.05f * std::pow(20.0f, random.between(0.0f, 1.0f));  // 5 cm to 1 m
        const std::vector<BodyId> crowd = fillFunnel(world, random, size);
        for (int n = 0; n < 240; ++n) step(world, kTick);
        EXPECT_EQ(countBelowFunnel(world, crowd, size), 0) << "member " << i << ", size " << size << " m";
    }
}

}  // namespace plumb::physics
