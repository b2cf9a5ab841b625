// Ragdolls fall on five floors; when all have been created, the oldest are removed and created again.

#include <memory>

#include "tests/bench/physics/ragdoll.hpp"
#include "tests/bench/physics/scenes.hpp"

namespace plumb::scenes {

namespace {

constexpr int kFloors = 5;
constexpr float kStorey = 45.0f;  // m: distance of two floors
constexpr float kTile = 0.5f;     // m: width of a floor tile
constexpr int kTiles = 500;
constexpr float kHalfWidth = 0.5f * kTile * kTiles;  // m
constexpr int kGroupSize = 5;
constexpr float kDrop = 40.0f;  // m: initial height above the floor
constexpr int kDelay = 8;       // steps between two columns

struct Rain {
    using Group = std::array<Ragdoll, kGroupSize>;

    int columns = 0;
    int made = 0;  ///< number of columns created
    int next = 0;  ///< next column to be removed and created again
    std::vector<Group> groups;

    Group& groupAt(int floor, int column) {
        return groups[static_cast<std::size_t>(floor * columns + column)];
    }

    void add(SceneBuilder& world, int floor, int column) {
        const float pitch = 2.0f * kHalfWidth / static_cast<float>(columns);
        Vec2 place{-kHalfWidth + pitch * (static_cast<float>(column) + 0.5f),
                   kDrop + kStorey * static_cast<float>(floor)};
        int number = 0;
        for (Ragdoll& ragdoll : groupAt(floor, column)) {
            ragdoll = addRagdoll(world, place, -(++number));
            place.x += 0.5f;
        }
    }

    void beforeStep(SceneBuilder& world, int step) {
        if (step % kDelay != 0) return;
        const bool full = made == columns;
        const int column = full ? next : made++;
        for (int floor = 0; floor < kFloors; ++floor) {
            if (full) {
                for (const Ragdoll& ragdoll : groupAt(floor, column)) removeRagdoll(world, ragdoll);
            }
            add(world, floor, column);
        }
        if (full) next = (next + 1) % columns;
    }
};

}  // namespace

BeforeStep buildRain(SceneBuilder& world, int columns) {
    const BodyHandle ground = world.createBody({.motion = Motion::Static});
    for (int floor = 0; floor < kFloors; ++floor) {
        for (int i = 0; i <= kTiles; ++i)
            world.addShape(ground,
                           box({0.5f * kTile, 0.5f * kTile}, {-kHalfWidth + kTile * static_cast<float>(i),
                                                              kStorey * static_cast<float>(floor)}));
    }
    const auto rain = std::make_shared<Rain>();
    rain->columns = columns;
    rain->groups.resize(static_cast<std::size_t>(columns * kFloors));
    return [rain](SceneBuilder& in, int step) { rain->beforeStep(in, step); };
}

}  // namespace plumb::scenes
