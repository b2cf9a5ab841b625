#include <algorithm>
#include <cmath>

#include "physics/debug/picture.hpp"

namespace plumb::physics {

namespace {

constexpr float kNormalLength = 0.2f;  // m
// Impulses are those of a substep, of which there are mostly four in a sixtieth of a second.
constexpr float kArrowPerSpeed = kArrowPerAcceleration * 240.0f;  // s

struct ContactPoint {
    Vec2 place;
    float impulse;  // N s
};

template <class Draw>
void forPoints(const Picture& picture, const Contact& contact, Draw&& draw) {
    for (int i = 0; i < contact.count; ++i) {
        draw(ContactPoint{picture.place(contact.bodyA, contact.anchors[i].a),
                          std::fabs(i == 0 ? contact.impulse0 : contact.impulse1)});
    }
}

/// m: of the arrow of an impulse, by the speed that it gives the lighter body.
float lengthOf(const Picture& picture, const Contact& contact, float impulse) {
    const auto& masses = picture.world.bodies.mass;
    const float lightest = std::max(masses[contact.bodyA].inverseMass, masses[contact.bodyB].inverseMass);
    return std::clamp(kArrowPerSpeed * impulse * lightest, -kLongestArrow, kLongestArrow);
}

}  // namespace

void drawContacts(const Picture& picture) {
    picture.forContacts(false, [&](const Contact& contact) {
        forPoints(picture, contact, [&](const ContactPoint& point) {
            picture.canvas.circle(point.place, kPointRadius, DebugRole::Contact);
        });
    });
}

void drawNormals(const Picture& picture) {
    picture.forContacts(false, [&](const Contact& contact) {
        forPoints(picture, contact, [&](const ContactPoint& point) {
            picture.canvas.arrow(point.place, point.place + kNormalLength * contact.normal,
                                 DebugRole::Normal);
        });
    });
}

void drawImpulses(const Picture& picture) {
    picture.forContacts(false, [&](const Contact& contact) {
        forPoints(picture, contact, [&](const ContactPoint& point) {
            if (point.impulse == 0.0f) return;
            const float length = lengthOf(picture, contact, point.impulse);
            picture.canvas.arrow(point.place, point.place + length * contact.normal, DebugRole::Impulse);
        });
    });
}

void drawFriction(const Picture& picture) {
    picture.forContacts(false, [&](const Contact& contact) {
        if (contact.frictionImpulse == 0.0f || contact.count == 0) return;
        Vec2 from;  // one impulse holds all points
        forPoints(picture, contact, [&](const ContactPoint& point) { from += point.place; });
        from = from / static_cast<float>(contact.count);
        const float length = lengthOf(picture, contact, contact.frictionImpulse);
        picture.canvas.arrow(from, from + length * perpendicular(contact.normal), DebugRole::Friction);
    });
}

}  // namespace plumb::physics
