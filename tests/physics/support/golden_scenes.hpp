#pragma once

#include <vector>

namespace plumb::physics {
struct World;
}

namespace plumb::physics::test {

/// A scene whose state hash after `steps` steps is recorded in tests/replay/physics.golden.
struct GoldenScene {
    const char* name;                                  ///< name in physics.golden
    World (*build)();                                  ///< creates the initial world
    int steps;                                         ///< number of steps
    bool joints = false;                               ///< true if the scene has joints
    bool contacts = true;                              ///< true if shapes touch at some time
    void (*before)(World& world, int step) = nullptr;  ///< called before each step
};

const std::vector<GoldenScene>& goldenScenes();

}  // namespace plumb::physics::test
