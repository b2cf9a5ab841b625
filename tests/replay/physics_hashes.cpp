// Prints the hash of each golden scene: ./plumb test --compilers compares what builds of all compilers print,
// ./plumb test --record keeps it in physics.golden.

#include <cstdio>

#include "physics/simulation.hpp"
#include "tests/physics/golden_scenes.hpp"

int main() {
    using namespace plumb::physics;
    for (const test::GoldenScene& scene : test::goldenScenes()) {
        World world = scene.build();
        for (int i = 0; i < scene.steps; ++i) {
            if (scene.before != nullptr) scene.before(world, i);
            step(world, 1.0f / 60.0f);
        }
        std::printf("%s %016llx\n", scene.name, static_cast<unsigned long long>(hashOf(world)));
    }
    return 0;
}
