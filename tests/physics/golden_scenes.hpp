#pragma once

#include <vector>

namespace plumb::physics {
struct World;
}

namespace plumb::physics::test {

/// A scene whose every bit is known after some steps: tests/replay/physics.golden.
struct GoldenScene {
    const char* name;
    World (*build)();
    int steps;
    bool joints = false;                               ///< it has some
    bool contacts = true;                              ///< something touches something, now and then
    void (*before)(World& world, int step) = nullptr;  ///< what happens before a step
};

const std::vector<GoldenScene>& goldenScenes();

}  // namespace plumb::physics::test
