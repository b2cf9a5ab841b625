#include <algorithm>
#include <cmath>

#include "physics/debug/picture.hpp"
#include "physics/islands/quality.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

constexpr float kNormalLength = 0.2f;  // m

/// Calls draw(contact, place, impulse) for each point of the contacts that are shown; impulses in N s.
template <class Draw>
void forPoints(const Picture& picture, Draw&& draw) {
    picture.forContacts(false, [&](const Contact& contact) {
        for (int i = 0; i < contact.count; ++i) {
            draw(contact, picture.place(contact.bodyA, pointOf(picture.world, contact, i)),
                 std::fabs(i == 0 ? contact.impulse0 : contact.impulse1));
        }
    });
}

/// Number of substeps whose impulses make up a step: contacts keep that of the last one. Sleeping bodies, and
/// worlds without a last step, use the quality that they ask for.
float partsOfStep(const Picture& picture, const Contact& contact) {
    const Bodies& bodies = picture.world.bodies;
    const BodyInfo& pushed = bodies.info[contact.bodyB];
    if (const Workspace* work = picture.choice.lastStep; work != nullptr && pushed.place != kNone) {
        const std::size_t group = work->groups.size() > 1 ? work->groupOf[contact.bodyB] : 0;
        if (group < work->groups.size()) return static_cast<float>(work->groups[group].substeps);
    }
    const Quality wished = std::max(bodies.info[contact.bodyA].quality, pushed.quality);
    return static_cast<float>(substepsOf(std::max(wished, picture.world.settings.quality)));
}

/// m: length of the arrow of an impulse, by the acceleration that it gives the lighter body over the whole
/// step.
float lengthOf(const Picture& picture, const Contact& contact, float impulse) {
    const auto& masses = picture.world.bodies.mass;
    const float lightest = std::max(masses[contact.bodyA].inverseMass, masses[contact.bodyB].inverseMass);
    const float speed = impulse * lightest * partsOfStep(picture, contact);
    return std::clamp(kArrowPerAcceleration * speed / picture.world.stepLength, -kLongestArrow,
                      kLongestArrow);
}

}  // namespace

void drawContacts(const Picture& picture) {
    forPoints(picture, [&](const Contact&, Vec2 place, float) {
        picture.canvas.circle(place, kPointRadius, DebugRole::Contact);
    });
}

void drawNormals(const Picture& picture) {
    forPoints(picture, [&](const Contact& contact, Vec2 place, float) {
        picture.canvas.arrow(place, place + kNormalLength * contact.normal, DebugRole::Normal);
    });
}

void drawImpulses(const Picture& picture) {
    forPoints(picture, [&](const Contact& contact, Vec2 place, float impulse) {
        if (impulse == 0.0f) return;
        const float length = lengthOf(picture, contact, impulse);
        picture.canvas.arrow(place, place + length * contact.normal, DebugRole::Impulse);
    });
}

void drawFriction(const Picture& picture) {
    picture.forContacts(false, [&](const Contact& contact) {
        if (contact.frictionImpulse == 0.0f || contact.count == 0) return;
        Vec2 from;  // one friction impulse acts for all points
        for (int i = 0; i < contact.count; ++i)
            from += picture.place(contact.bodyA, pointOf(picture.world, contact, i));
        from = from / static_cast<float>(contact.count);
        const float length = lengthOf(picture, contact, contact.frictionImpulse);
        picture.canvas.arrow(from, from + length * perpendicular(contact.normal), DebugRole::Friction);
    });
}

}  // namespace plumb::physics
