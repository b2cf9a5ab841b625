#include <algorithm>
#include <stdexcept>

#include "physics/queries/lists.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

namespace plumb::physics {
namespace {

struct Beside : Playground {
    BodyId ground, crate;
    ShapeId below, shape;

    Beside() {
        world.settings.sleeping = true;
        ground = addBody(world, BodyKind::Static, {0.0, -1.0});
        below = *createShape(world, ground, box({10.0f, 1.0f}));
        crate = addBody(world, BodyKind::Dynamic, {0.0, 0.5});
        shape = *createShape(world, crate, box({0.5f, 0.5f}));
    }

    /// Number of contacts between the crate and another shape that begin (or end) within `steps` steps.
    int count(ContactPhase phase, ShapeId with, int steps) {
        int found = 0;
        for (int i = 0; i < steps; ++i) {
            step(world, kTick);
            found +=
                static_cast<int>(std::count_if(world.events.begin(), world.events.end(), [&](const auto& e) {
                    return e.phase == phase && (e.shapeA == with || e.shapeB == with) &&
                           (e.shapeA == shape || e.shapeB == shape);
                }));
        }
        return found;
    }
};

enum class Way { Created, Moved, TurnedInto, Enabled, Count };

/// Puts a trigger of 2 m width over the sleeping crate by one of four edits (`way`).
ShapeId putTrigger(Beside& scene, BodyKind kind, Way way) {
    World& world = scene.world;
    const bool isThere = way != Way::Created;
    const auto make = [&](double x) {
        return *createBody(world, {.kind = kind, .position = {x, 0.5}, .gravityScale = 0.0f});
    };
    const auto cover = [&](BodyId body, bool isTrigger) {
        return *createShape(world, body, box({1.0f, 1.0f}),
                            {.layers = 2, .mask = isTrigger ? ~0u : 0u, .isTrigger = isTrigger});
    };
    BodyId body;
    ShapeId trigger;
    if (isThere) {
        body = make(way == Way::Moved ? 50.0 : 0.0);
        trigger = cover(body, way != Way::TurnedInto);
        setEnabled(world, body, way != Way::Enabled);
    }
    scene.run(120);
    EXPECT_FALSE(isAwake(world, scene.crate));
    if (!isThere) trigger = cover(make(0.0), true);
    if (way == Way::Moved) {
        EXPECT_TRUE(setPosition(world, body, {0.0, 0.5}, 0.0f).ok());
    }
    if (way == Way::TurnedInto) {
        EXPECT_TRUE(
            change(world, trigger, [](ShapeDefinition& d) { d.isTrigger = true, d.mask = ~0u; }).ok());
    }
    if (way == Way::Enabled) setEnabled(world, body, true);
    return trigger;
}

TEST(EditsBesideSleepers, aTriggerReportsASleepingBodyOverWhichItIsPlaced) {
    for (const BodyKind kind : {BodyKind::Static, BodyKind::Kinematic, BodyKind::Dynamic}) {
        for (int way = 0; way < static_cast<int>(Way::Count); ++way) {
            Beside scene;
            const ShapeId trigger = putTrigger(scene, kind, static_cast<Way>(way));
            EXPECT_EQ(scene.count(ContactPhase::Began, trigger, 5), 1)
                << static_cast<int>(kind) << ' ' << way;
            std::vector<ShapeId> inside;
            overlapsOf(scene.world, trigger, inside);
            EXPECT_EQ(std::count(inside.begin(), inside.end(), scene.shape), 1) << way;
            // The crate falls asleep again, without another event.
            EXPECT_EQ(scene.count(ContactPhase::Began, trigger, 120), 0) << way;
            EXPECT_FALSE(isAwake(scene.world, scene.crate)) << way;
        }
    }
}

TEST(EditsBesideSleepers, aBodyCreatedAsleepInATriggerIsReported) {
    Beside scene;
    const BodyId zone = addBody(scene.world, BodyKind::Static, {5.0, 1.0});
    const ShapeId trigger = *createShape(scene.world, zone, box({1.0f, 1.0f}), {.isTrigger = true});
    const BodyId body = *createBody(scene.world, {.position = {5.0, 0.5}, .awake = false});
    scene.shape = *createShape(scene.world, body, box({0.5f, 0.5f}));
    EXPECT_EQ(scene.count(ContactPhase::Began, trigger, 5), 1);
}

TEST(EditsBesideSleepers, editsEndContactsEvenIfTheBodyIsPutToSleepAtOnce) {
    using Edit = void (*)(Beside&);
    const Edit edits[] = {
        [](Beside& s) { destroyBody(s.world, s.ground); },
        [](Beside& s) { destroyShape(s.world, s.below); },
        [](Beside& s) { setFilter(s.world, s.below, 2, 0, 0); },
        [](Beside& s) { setEnabled(s.world, s.ground, false); },
        [](Beside& s) {
            EXPECT_TRUE(setPosition(s.world, s.ground, {200.0, 0.0}, 0.0f).ok());
        },
        [](Beside& s) {
            EXPECT_TRUE(setGeometry(s.world, s.below, box({0.1f, 0.1f}, {50.0f, 0.0f})).ok());
        }};
    for (std::size_t i = 0; i < std::size(edits); ++i) {
        Beside scene;
        scene.run(10);
        edits[i](scene);
        setAwake(scene.world, scene.crate, false);
        EXPECT_EQ(scene.count(ContactPhase::Ended, scene.below, 3), 1) << "edit " << i;
        std::vector<const Contact*> left;
        contactsOf(scene.world, scene.crate, left);
        EXPECT_TRUE(left.empty()) << "edit " << i;
    }
}

TEST(EditsBesideSleepers, setAwakeFalsePutsAnUneditedBodyToSleep) {
    Beside scene;
    scene.run(10);
    EXPECT_TRUE(isAwake(scene.world, scene.crate));
    setAwake(scene.world, scene.crate, false);
    EXPECT_FALSE(isAwake(scene.world, scene.crate));
}

// A callback must not change the world that calls it, but may change a copy of that world.
TEST(Callbacks, mayCopyTheWorldToChangeTheCopy) {
    Beside scene;
    World copy;
    StepOptions options;
    options.hooks.context = &copy;
    options.hooks.preSolve = [](void* to, const World& now, const Contact&) {
        *static_cast<World*>(to) = now;
        return true;
    };
    for (int i = 0; i < 3; ++i) step(scene.world, kTick, options);
    ASSERT_GT(copy.steps, 0u);
    EXPECT_TRUE(createBody(copy, {}).ok());
    step(copy, kTick);
    EXPECT_EQ(copy.steps, scene.world.steps + 1);
}

TEST(Callbacks, thatThrowLeaveTheWorldEditable) {
    Beside scene;
    StepOptions options;
    options.hooks.preSolve = [](void*, const World&, const Contact&) -> bool {
        throw std::runtime_error{"no"};
    };
    EXPECT_THROW(for (int i = 0; i < 3; ++i) step(scene.world, kTick, options), std::runtime_error);
    EXPECT_TRUE(createBody(scene.world, {}).ok());
}

}  // namespace
}  // namespace plumb::physics
