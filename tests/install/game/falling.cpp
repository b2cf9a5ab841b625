#include <cstdio>
#include <plumb_physics.hpp>

// Example of a program that links only the physics library. It prints what happens to a small cube in
// separate worlds: it hits a light and a heavy cube, slides on smooth and rough floors, bounces, and passes
// through a spinning trigger that changes its colour. y points down.

using namespace plumb;
using namespace plumb::physics;

struct Cube : BoxCollider {
    using BoxCollider::BoxCollider;
    const char* colour = "blue";
};

struct Spinner : BoxCollider {
    using BoxCollider::BoxCollider;
    void onCollisionEnter(Collider* other) override { recolour(other, "red"); }
    void onCollisionExit(Collider* other) override { recolour(other, "blue"); }
    static void recolour(Collider* other, const char* colour) {
        if (auto* cube = dynamic_cast<Cube*>(other)) {
            cube->colour = colour;
            std::printf("the cube is %s\n", colour);
        }
    }
};

namespace {

void run(Physics& physics, int ticks) {
    for (int i = 0; i < ticks; ++i) physics.update(1.0f / 60.0f);
}

RigidBody& add(Physics& physics, WorldPosition place, float half, float mass, bool gravity,
               const ColliderSettings& settings) {
    RigidBody& body = **physics.createBody(place);
    static_cast<void>(physics.create<Cube>(&body, Vec2{half, half}, settings));
    static_cast<void>(body.setMass(mass));
    body.useGravity(gravity);
    body.constrainRotation(true);
    return body;
}

/// Speed of another cube of this mass after the small cube hit it, m/s.
float pushed(float mass) {
    Physics physics;
    RigidBody& small = add(physics, {-2.0, 0.0}, 0.5f, 1.0f, false, {});
    RigidBody& other = add(physics, {0.0, 0.0}, 0.5f, mass, false, {});
    static_cast<void>(small.setVelocity({4.0f, 0.0f}));
    run(physics, 60);
    return other.velocity().x;
}

/// Distance that a push moves the small cube over a static cube of this friction, m.
double slid(float friction) {
    Physics physics;
    static_cast<void>(physics.create<BoxCollider>(
        nullptr, Vec2{50.0f, 1.0f}, ColliderSettings{.friction = friction, .position = {0.0, 1.0}}));
    RigidBody& small = add(physics, {0.0, -0.5}, 0.5f, 1.0f, true, {});
    static_cast<void>(small.setVelocity({5.0f, 0.0f}));
    run(physics, 120);
    return small.position().x;
}

}  // namespace

int main() {
    Physics physics;
    static_cast<void>(physics.create<BoxCollider>(
        nullptr, Vec2{50.0f, 1.0f}, ColliderSettings{.bounciness = 0.5f, .position = {0.0, 6.0}}));
    RigidBody& cube = add(physics, {0.0, 0.0}, 0.1f, 1.0f, true, {});
    run(physics, 54);
    std::printf("fell %.3f m in 0.9 s\n", cube.position().y);
    float up = 0.0f;
    for (int i = 0; i < 30; ++i) run(physics, 1), up = up < -cube.velocity().y ? -cube.velocity().y : up;
    std::printf("bounced with %.1f m/s\n", static_cast<double>(up));

    RigidBody& axle = **physics.createBody({5.0, 4.5});
    static_cast<void>(physics.create<Spinner>(&axle, Vec2{1.0f, 1.0f}, ColliderSettings{.isTrigger = true}));
    axle.useGravity(false);
    static_cast<void>(axle.setAngularVelocity(2.0f));
    static_cast<void>(cube.setPosition({0.0, 4.9}));
    cube.useGravity(false);
    static_cast<void>(cube.setVelocity({5.0f, 0.0f}));
    run(physics, 150);

    std::printf("pushed %s\n", pushed(0.5f) > 4.0f * pushed(20.0f) ? "the heavy one less" : "both alike");
    std::printf("slid %.1f m on rough ground, %.1f m on smooth\n", slid(0.6f), slid(0.0f));
}
