#include "tests/physics/support/world_of_bodies.hpp"

namespace plumb::physics {
namespace {

// Every begin event is followed by an end event, even if no effect requires contacts afterwards.
TEST(LastContact, endsWithTheLastShape) {
    for (const bool bodies : {true, false}) {
        Playground play;
        const BodyId floor = *createBody(play.world, {.kind = BodyKind::Static, .position = {0.0, -1.0}});
        const BodyId crate = *createBody(play.world, {.position = {0.0, 0.5}});
        const ShapeId below = *createShape(play.world, floor, box({5.0f, 1.0f}));
        const ShapeId above = *createShape(play.world, crate, box({0.5f, 0.5f}));
        int began = 0, ended = 0;
        const auto run = [&] {
            step(play.world, kTick);
            for (const ContactEvent& event : play.world.events) {
                began += event.phase == ContactPhase::Began ? 1 : 0;
                ended += event.phase == ContactPhase::Ended ? 1 : 0;
            }
        };
        for (int i = 0; i < 10; ++i) run();
        EXPECT_EQ(began, 1);
        if (bodies) {
            destroyBody(play.world, crate);
            destroyBody(play.world, floor);
        } else {
            destroyShape(play.world, above);
            destroyShape(play.world, below);
        }
        for (int i = 0; i < 3; ++i) run();
        EXPECT_EQ(ended, 1);
        EXPECT_TRUE(play.world.contacts.empty());
    }
}

}  // namespace
}  // namespace plumb::physics
