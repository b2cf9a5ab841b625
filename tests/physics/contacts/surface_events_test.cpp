#include <map>

#include "tests/physics/support/world_of_bodies.hpp"

namespace plumb::physics {
namespace {

/// The two sides of a contact: each a single shape or a surface.
using Touch = std::pair<std::uint64_t, std::uint64_t>;

/// Returns both sides of an event, the smaller one first.
Touch touchOf(const ContactEvent& event, const std::map<std::uint32_t, std::uint64_t>& sides) {
    const std::uint64_t a = sides.at(event.shapeA.index), b = sides.at(event.shapeB.index);
    return {std::min(a, b), std::max(a, b)};
}

TEST(SurfaceEvents, beginAndEndAlternatelyForEachBodyOnEachSurface) {
    int began = 0, ended = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        Playground scene;
        World& world = scene.world;
        world.settings.stayEvents = seed % 2 == 0;
        world.settings.sleeping = seed % 3 == 0;
        world.settings.sleepTime = 0.1f;
        // Three floors of many shapes with one surface each, of which the second is one-way, and a trigger of
        // two shapes.
        std::map<std::uint32_t, std::uint64_t> sides;  // surface of each shape
        const auto note = [&](ShapeId shape, std::uint64_t side) { sides[shape.index] = side; };
        const BodyId ground = scene.body(BodyKind::Static, {});
        for (std::uint32_t floor = 1; floor <= 3; ++floor) {
            for (int i = 0; i < 12; ++i) {
                const Geometry piece =
                    box({0.5f, 0.1f}, {static_cast<float>(i) - 6.0f, 2.0f * static_cast<float>(floor)});
                ShapeDefinition definition{.surface = floor};
                definition.oneWay = floor == 2;
                definition.oneWayDirection = {0.0f, 1.0f};
                note(scene.shape(ground, piece, definition), 1000 + floor);
            }
        }
        for (int i = 0; i < 2; ++i)
            note(scene.shape(ground, box({1.0f, 1.0f}, {static_cast<float>(i), 3.0f}),
                             {.isTrigger = true, .surface = 9}),
                 1009);
        std::vector<BodyId> movers;
        for (int i = 0; i < 8; ++i) {
            const BodyId mover =
                scene.body(BodyKind::Dynamic, {-4.0 + i, 7.0 - i % 3 * 2.0}, random.between(-1.0f, 1.0f));
            note(scene.shape(mover, i % 2 == 0 ? box({0.3f, 0.2f}) : circle(0.25f)),
                 static_cast<std::uint64_t>(i));
            movers.push_back(mover);
        }
        std::map<Touch, int> touching;
        for (int tick = 0; tick < 240; ++tick) {
            const BodyId mover = movers[random.below(8)];
            switch (random.below(24)) {
                case 0:
                    static_cast<void>(setVelocity(world, mover, {random.between(-6.0f, 6.0f), 4.0f}));
                    break;
                case 1:
                    static_cast<void>(setPosition(world, mover, {random.between(-5.0f, 5.0f), 7.5}, 0.0f));
                    break;
                case 2: setDropThrough(world, mover, random.below(2) == 0); break;
                case 3:
                    setFilter(world, {world.bodies.info[mover.index].firstShape, 1}, 1,
                              random.below(3) == 0 ? 0u : ~0u, 0);
                    break;
                default: break;
            }
            if (tick % 50 == 49) {
                const World copy = world;  // contact counts are not copied but restored from the contacts
                world = copy;
            }
            scene.run(1);
            for (const ContactEvent& event : world.events) {
                int& count = touching[touchOf(event, sides)];
                switch (event.phase) {
                    case ContactPhase::Began: ASSERT_EQ(++count, 1) << tick; break;
                    case ContactPhase::Ended: ASSERT_EQ(--count, 0) << tick; break;
                    default: ASSERT_EQ(count, 1) << tick; ASSERT_TRUE(world.settings.stayEvents);
                }
                began += event.phase == ContactPhase::Began ? 1 : 0;
                ended += event.phase == ContactPhase::Ended ? 1 : 0;
            }
        }
    }
    EXPECT_GT(began, 200);
    EXPECT_GT(ended, 150);
}

}  // namespace
}  // namespace plumb::physics
