#include <cstdio>

#include "box_physics/simulation.hpp"

// Links the physics library alone.

int main() {
    plumb::box_physics::World world;
    plumb::box_physics::BodyDefinition ball;
    ball.shape = plumb::box_physics::Shape::circle(0.5f);
    const auto body = plumb::box_physics::createBody(world, ball);
    if (!body) return 1;
    for (int tick = 0; tick < 60; ++tick) plumb::box_physics::step(world, {}, 1.0f / 60.0f);
    std::printf("fell %.3f m in 1 s\n", static_cast<double>(world.bodies.position[body->index].y));
}
