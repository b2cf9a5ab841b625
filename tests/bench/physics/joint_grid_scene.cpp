// A grid of circles, each connected to its neighbours by hinges; seven circles of the upper edge are static.

#include "tests/bench/physics/scenes.hpp"

namespace plumb::scenes {

BeforeStep buildJointGrid(SceneBuilder& world, int side) {
    constexpr int kReach = 3;  // static bodies on each side of the middle one
    constexpr std::uint32_t kLayer = 2;
    const Material material{.layers = kLayer, .mask = ~kLayer};
    std::vector<BodyHandle> bodies;
    for (int k = 0; k < side; ++k) {
        for (int i = 0; i < side; ++i) {
            const bool held = i == 0 && k >= side / 2 - kReach && k <= side / 2 + kReach;
            const BodyHandle body =
                world.createBody({.motion = held ? Motion::Static : Motion::Dynamic,
                                  .position = {static_cast<float>(k), -static_cast<float>(i)}});
            world.addShape(body, circle(0.4f), material);
            if (i > 0)
                world.addJoint(
                    {.a = bodies.back(), .b = body, .anchorA = {0.0f, -0.5f}, .anchorB = {0.0f, 0.5f}});
            if (k > 0)
                world.addJoint({.a = bodies[bodies.size() - static_cast<std::size_t>(side)],
                                .b = body,
                                .anchorA = {0.5f, 0.0f},
                                .anchorB = {-0.5f, 0.0f}});
            bodies.push_back(body);
        }
    }
    return {};
}

}  // namespace plumb::scenes
