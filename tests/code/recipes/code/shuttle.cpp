#include <plumb.hpp>

using namespace plumb;

struct Shuttle {
    Vec2 way = {100.0f, 0.0f};  ///< px, from the initial position to the other end
    float speed = 60.0f;        ///< px/s
    Vec2 home;                  ///< px, initial position
    int direction = 0;          ///< 1: to the other end, -1: back, 0: not started

    static void describe(TypeBuilder<Shuttle>& type) {
        type.name("Shuttle").doc("Moves a KinematicBody back and forth.");
        type.field<&Shuttle::way>("way").unit(Unit::Pixels).doc("To the other end, px.");
        type.field<&Shuttle::speed>("speed").unit(Unit::PixelsPerSecond).range(0.0f, 2000.0f);
        type.field<&Shuttle::home>("home").unit(Unit::Pixels).transient();
        type.field<&Shuttle::direction>("direction").transient();
    }
};

struct ShuttleSystem {
    void update(World& world, float) {
        for (auto [entity, shuttle, body, transform] :
             world.query<Shuttle, KinematicBody, const Transform>()) {
            if (shuttle.direction == 0) shuttle.home = transform.position, shuttle.direction = 1;
            const float done = dot(transform.position - shuttle.home, normalized(shuttle.way));  // px
            if (done >= length(shuttle.way)) shuttle.direction = -1;
            if (done <= 0.0f) shuttle.direction = 1;
            const auto sign = static_cast<float>(shuttle.direction);
            body.velocity = normalized(shuttle.way) * (sign * shuttle.speed);
        }
    }
};

void addShuttles(Module& module) {
    module.components<Shuttle>();
    module.system<ShuttleSystem, Shuttle>(before<PhysicsSystem>());
}
