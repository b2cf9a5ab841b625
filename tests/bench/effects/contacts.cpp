#include <cstdio>

#include "tests/bench/effects/effects_bench.hpp"

namespace plumb::bench {

namespace {

using namespace physics;

constexpr int kBoxes = 2000;

/// Effects that are active in a pit of boxes.
struct Pit {
    const char* name;
    bool turns = false;       // boxes can rotate
    bool rubs = false;        // friction
    bool bounces = false;     // bounciness
    bool reports = false;     // events when contacts begin and end
    bool stayEvents = false;  // events in each step of a contact
    bool rolls = false;       // rolling resistance
    bool slows = false;       // drag
    bool sweeps = false;      // continuous collision, against tunnelling
    bool oneWay = false;      // the floor is one-way
    bool sleeps = false;      // checks which bodies may sleep; the sleep time is so long that none does
};

constexpr int kBare = 6;  // index in kPits of the pit without effects, the reference for the ratios

World makePit(const Pit& pit) {
    World world;
    world.settings.gravity = {0.0f, -10.0f};
    world.settings.sleeping = pit.sleeps;
    world.settings.sleepTime = 1.0e9f;
    world.settings.stayEvents = pit.stayEvents;
    world.settings.continuous = pit.sweeps;
    ShapeDefinition shape;
    shape.friction = pit.rubs ? 0.6f : 0.0f;
    shape.bounciness = pit.bounces ? 0.1f : 0.0f;
    shape.rollingResistance = pit.rolls ? 0.01f : 0.0f;
    shape.reportsContacts = pit.reports;
    const BodyId ground = *createBody(world, {.kind = BodyKind::Static, .position = {0.0, -1.0}});
    ShapeDefinition floor = shape;
    floor.oneWay = pit.oneWay;
    floor.oneWayDirection = {0.0f, 1.0f};
    static_cast<void>(createShape(world, ground, box({60.0f, 1.0f}), floor));
    for (const float side : {-21.0f, 21.0f})
        static_cast<void>(createShape(world, ground, box({1.0f, 60.0f}, {side, 61.0f}), shape));
    for (int i = 0; i < kBoxes; ++i) {
        const int row = i / 39;
        BodyDefinition body;
        body.position = {-19.5 + (i % 39) + (row % 2 == 0 ? 0.0 : 0.3), 0.5 + 1.05 * row};
        body.fixedRotation = !pit.turns;
        body.linearDrag = body.angularDrag = pit.slows ? 0.01f : 0.0f;
        static_cast<void>(createShape(world, *createBody(world, body), box({0.5f, 0.5f}), shape));
    }
    return world;
}

int touching(const World& world) {
    int count = 0;
    for (const Contact& contact : world.contacts) count += (contact.flags & kTouching) != 0 ? 1 : 0;
    return count;
}

}  // namespace

int measureContacts(bool quick) {
    constexpr Pit kPits[] = {
        {.name = "all effects of a box",
         .turns = true,
         .rubs = true,
         .bounces = true,
         .reports = true,
         .stayEvents = true,
         .rolls = true,
         .slows = true,
         .sweeps = true,
         .oneWay = true,
         .sleeps = true},
        {.name = "all but drag, sweeps, one-way, sleep",
         .turns = true,
         .rubs = true,
         .bounces = true,
         .reports = true,
         .stayEvents = true,
         .rolls = true},
        {.name = "rotation, friction, bounce, events",
         .turns = true,
         .rubs = true,
         .bounces = true,
         .reports = true},
        {.name = "rotation, friction, events", .turns = true, .rubs = true, .reports = true},
        {.name = "rotation, events", .turns = true, .reports = true},
        {.name = "friction, events", .rubs = true, .reports = true},
        {.name = "none: boxes that cannot rotate"},
        {.name = "rotation, friction, stay events",
         .turns = true,
         .rubs = true,
         .reports = true,
         .stayEvents = true},
    };
    constexpr int kPitCount = static_cast<int>(std::size(kPits));
    World worlds[kPitCount];
    double best[kPitCount];
    for (int i = 0; i < kPitCount; ++i) {
        worlds[i] = makePit(kPits[i]);
        best[i] = 1.0e12;
        for (int warm = 0; warm < 100; ++warm) step(worlds[i], kTick);
    }
    // Alternate the pits, so that other work of the machine affects all equally.
    for (int round = 0; round < (quick ? 1 : 30); ++round) {
        for (int i = 0; i < kPitCount; ++i) {
            const double time = quickest(5, [&] { step(worlds[i], kTick); });
            best[i] = std::min(best[i], time / touching(worlds[i]));
        }
    }
    std::printf("a pit of %d boxes, one thread\n%-38s%12s%12s%10s\n", kBoxes, "effects", "touching",
                "ns each", "ratio");
    for (int i = 0; i < kPitCount; ++i) {
        std::printf("%-38s%12d%12.1f%10.2f\n", kPits[i].name, touching(worlds[i]), best[i],
                    best[i] / best[kBare]);
    }
    std::printf("stay events make a step %.1f %% slower\n", 100.0 * (best[7] / best[3] - 1.0));
    return 0;
}

}  // namespace plumb::bench
