#pragma once

#include <vector>

namespace plumb::physics {
struct World;
}

namespace plumb::physics::test {

/// A scene whose exact bits after some steps are recorded: tests/replay/physics.golden.
struct GoldenScene {
    const char* name;
    World (*build)();
    int steps;
    bool joints = false;                               ///< it has some
    bool contacts = true;                              ///< some shapes touch at some time
    void (*before)(World& world, int step) = nullptr;  ///< called before each step
};

const std::vector<GoldenScene>& goldenScenes();

}  // namespace plumb::physics::test
