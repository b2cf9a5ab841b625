#include <cstdio>

#include "physics/simulation.hpp"

// Links the physics library alone.

int main() {
    plumb::physics::World world;
    plumb::physics::BodyDefinition ball;
    ball.shape = plumb::physics::Shape::circle(0.5f);
    const auto body = plumb::physics::createBody(world, ball);
    if (!body) return 1;
    for (int tick = 0; tick < 60; ++tick) plumb::physics::step(world, {}, 1.0f / 60.0f);
    std::printf("fell %.3f m in 1 s\n", static_cast<double>(world.bodies.position[body->index].y));
}
