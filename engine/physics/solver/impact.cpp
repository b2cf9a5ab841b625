#include "physics/solver/impact.hpp"

#include <algorithm>

#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

struct ImpactPoint {
    Vec2 armA;
    Vec2 armB;
    float massAlong = 0.0f;   // kg: effective mass along the normal
    float massAcross = 0.0f;  // kg: effective mass along the surface
    Vec2 approach;            // m/s, before the impact: along the normal and along the surface
    float closing = 0.0f;     // m/s: maximum approach speed after the impact
    float push = 0.0f;        // N s, normal impulse
    float stopping = 0.0f;    // N s: part of `push` without restitution
    float rub = 0.0f;         // N s, friction impulse
};

class Exchange {
public:
    Exchange(const Contact& contact, ImpactBody& a, ImpactBody& b, float timeLeft, float slop)
        : contact_{contact}, a_{a}, b_{b}, normal_{contact.normal}, along_{perpendicular(contact.normal)} {
        const float separations[] = {contact.separation0, contact.separation1};
        const float touching = std::min(contact.separation0, contact.separation1);
        for (int i = 0; i < contact.count; ++i) {
            ImpactPoint& point = points_[i];
            point.armA = rotate(a.pose.rotation, contact.anchors[i].a);
            point.armB = rotate(b.pose.rotation, contact.anchors[i].b);
            point.massAlong = massAt(point, normal_);
            point.massAcross = massAt(point, along_);
            point.approach = speedAt(point);
            const float gap = separations[i] - touching;
            if (gap > slop)
                point.closing = timeLeft > 0.0f ? gap / timeLeft : std::numeric_limits<float>::max();
        }
    }

    void stop() {
        for (int iteration = 0; iteration < kTwoPointTurns; ++iteration) {
            for (ImpactPoint& point : points()) {
                push(point, -point.closing);
                const float maximum = contact_.friction * point.push, before = point.rub;
                point.rub = std::clamp(before - point.massAcross * speedAt(point).y, -maximum, maximum);
                apply(point, (point.rub - before) * along_);
            }
        }
    }

    void bounce(float bounceSpeed) {
        for (int iteration = 0; iteration < kTwoPointTurns; ++iteration) {
            for (ImpactPoint& point : points()) {
                if (iteration == 0) point.stopping = point.push;
                const bool bounces = point.closing == 0.0f && point.approach.x < -bounceSpeed;
                if (point.push > 0.0f)
                    push(point, bounces ? -contact_.bounciness * point.approach.x : -point.closing);
            }
        }
    }

    /// Scales the impulses of bounce() by a factor.
    void keep(float part) {
        for (ImpactPoint& point : points()) {
            const float back = (1.0f - part) * (point.push - point.stopping);
            apply(point, -back * normal_);
            point.push -= back;
        }
    }

    /// Returns the change of energy (J) of both bodies, from the work of the impulses at their points.
    [[nodiscard]] float gain() {
        float gain = 0.0f;
        for (const ImpactPoint& point : points())
            gain += dot(0.5f * (point.approach + speedAt(point)), {point.push, point.rub});
        return gain;
    }
    [[nodiscard]] std::span<ImpactPoint> points() {
        return {points_, static_cast<std::size_t>(contact_.count)};
    }

private:
    [[nodiscard]] float massAt(const ImpactPoint& point, Vec2 direction) const {
        const float rotationA = cross(point.armA, direction), rotationB = cross(point.armB, direction);
        const float inverse = a_.mass.inverseMass + b_.mass.inverseMass +
                              a_.mass.inverseInertia * rotationA * rotationA +
                              b_.mass.inverseInertia * rotationB * rotationB;
        return inverse > 0.0f ? 1.0f / inverse : 0.0f;
    }
    /// Velocity (m/s) of B relative to A: along the normal, and along the surface minus surfaceSpeed.
    [[nodiscard]] Vec2 speedAt(const ImpactPoint& point) const {
        const Vec2 speed = b_.motion.velocity + cross(b_.motion.angularVelocity, point.armB) -
                           a_.motion.velocity - cross(a_.motion.angularVelocity, point.armA);
        return {dot(speed, normal_), dot(speed, along_) - contact_.surfaceSpeed};
    }
    void push(ImpactPoint& point, float wanted) {
        const float after = std::max(point.push - point.massAlong * (speedAt(point).x - wanted), 0.0f);
        apply(point, (after - point.push) * normal_);
        point.push = after;
    }
    void apply(const ImpactPoint& point, Vec2 impulse) {
        a_.motion.velocity -= a_.mass.inverseMass * impulse;
        a_.motion.angularVelocity -= a_.mass.inverseInertia * cross(point.armA, impulse);
        b_.motion.velocity += b_.mass.inverseMass * impulse;
        b_.motion.angularVelocity += b_.mass.inverseInertia * cross(point.armB, impulse);
    }

    const Contact& contact_;
    ImpactBody& a_;
    ImpactBody& b_;
    Vec2 normal_;
    Vec2 along_;
    ImpactPoint points_[2];
};

}  // namespace

void exchangeImpulses(Contact& contact, ImpactBody& a, ImpactBody& b, float left, const Settings& settings) {
    Exchange impact{contact, a, b, left, settings.slop};
    impact.stop();
    const float before = impact.gain();
    impact.bounce(settings.bounceSpeed);
    // If friction rotates bodies, a bounce at full speed may add energy. The energy is a convex function of
    // the applied fraction of the bounce, so this fraction adds none.
    if (const float after = impact.gain(); after > 0.0f) impact.keep(before / (before - after));
    contact.impulse0 = -impact.points()[0].push;  // negative: not for warm starting
    contact.impulse1 = contact.count == 2 ? -impact.points()[1].push : 0.0f;
}

}  // namespace plumb::physics
