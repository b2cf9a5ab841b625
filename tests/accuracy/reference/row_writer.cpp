#include "tests/accuracy/reference/row_writer.hpp"

#include <numbers>

namespace plumb::reference {

namespace {

Triple ways(Triple inverseMass) {
    const auto way = [](double inverse) { return inverse > 0.0 ? 1.0 : 0.0; };
    return {way(inverseMass.x), way(inverseMass.y), way(inverseMass.turn)};
}

/// Takes components from `value` where `way` is above 0 (free directions), else from `locked`. In locked
/// directions a system has a mass of 1, and a momentum equal to the prescribed velocity.
Triple withLocked(Triple value, Triple locked, Triple way) {
    return {way.x > 0.0 ? value.x : locked.x, way.y > 0.0 ? value.y : locked.y,
            way.turn > 0.0 ? value.turn : locked.turn};
}

Gradient combined(double a, const Gradient& one, double b, const Gradient& two) {
    return {a * one.a + b * two.a, a * one.b + b * two.b, a * one.value + b * two.value};
}

}  // namespace

void RowWriter::setGroup(const Group& group) {
    group_ = &group;
    for (std::size_t i = 0; i < group.bodies.size(); ++i)
        localOf_[group.bodies[i]] = static_cast<std::uint32_t>(i);
}

Triple RowWriter::inverseMassOf(std::uint32_t local) const {
    return local < group_->pushed ? bodyAt(local).inverseMass : Triple{};
}

void RowWriter::beginStep(RowSystem& system, const std::vector<Triple>& velocities, double h) {
    system = {};
    known_ = velocities;
    for (std::size_t i = 0; i < group_->pushed; ++i) {
        const Body& body = bodyAt(i);
        const Triple drag{0.5 * h * body.linearDrag, 0.5 * h * body.linearDrag, 0.5 * h * body.angularDrag};
        const Triple one{1.0, 1.0, 1.0}, way = ways(body.inverseMass);
        const Triple force = scaled(body.mass, {body.acceleration.x, body.acceleration.y, 0.0});
        const Triple momentum = scaled(body.mass, scaled(one - drag, velocities[i])) + h * force;
        system.mass.push_back(withLocked(scaled(body.mass, one + drag), one, way));
        system.momentum.push_back(withLocked(momentum, velocities[i], way));
    }
}

void RowWriter::beginImpact(RowSystem& system, const std::vector<Triple>& velocities) {
    system = {};
    known_ = velocities;
    for (std::size_t i = 0; i < group_->pushed; ++i) {
        const Body& body = bodyAt(i);
        const Triple way = ways(body.inverseMass);
        system.mass.push_back(withLocked(body.mass, {1.0, 1.0, 1.0}, way));
        system.momentum.push_back(withLocked(scaled(body.mass, velocities[i]), velocities[i], way));
    }
}

void RowWriter::beginShift(RowSystem& system) {
    beginImpact(system, std::vector<Triple>(group_->bodies.size()));
}

std::uint32_t RowWriter::add(RowSystem& system, const Gradient& push, const Gradient& speed,
                             std::uint32_t localA, std::uint32_t localB, Row row) const {
    const auto side = [&](std::uint32_t local, Triple pushed, Triple seen, std::uint32_t& body,
                          Triple& rowPush, Triple& rowSpeed) {
        const Triple way = ways(inverseMassOf(local));
        const Triple all{1.0, 1.0, 1.0};
        row.target -= dot(scaled(seen, all - way), known_[local]);
        if (largest(way) == 0.0) return;
        body = local;
        rowPush = scaled(pushed, way);
        rowSpeed = scaled(seen, way);
    };
    side(localA, push.a, speed.a, row.a, row.pushA, row.speedA);
    side(localB, push.b, speed.b, row.b, row.pushB, row.speedB);
    system.rows.push_back(row);
    return static_cast<std::uint32_t>(system.rows.size() - 1);
}

double RowWriter::give(const Gradient& one, const Gradient& two, const Law& law) const {
    return dot(one.a, scaled(inverseMassOf(local(law.a)), two.a)) +
           dot(one.b, scaled(inverseMassOf(local(law.b)), two.b));
}

double RowWriter::rate(const Gradient& gradient, const Law& law,
                       const std::vector<Triple>& velocities) const {
    return dot(gradient.a, velocities[local(law.a)]) + dot(gradient.b, velocities[local(law.b)]);
}

/// Adds a damped spring by the midpoint rule: its force depends on the mean velocity of the step and on the
/// position in the middle of the step, which is linear in the velocity at the end.
void RowWriter::addSpringRow(RowSystem& system, const Law& law, const Gradient& gradient, double speedAtStart,
                             double speedAtGuess, double h) const {
    const double inverse = give(gradient, gradient, law);
    const double omega = 2.0 * std::numbers::pi * law.hertz;
    if (!(inverse > 0.0) || !(omega > 0.0)) return;
    const double stiffness = omega * omega / inverse, damping = 2.0 * law.dampingRatio * omega / inverse;
    const double perSpeed = h * (0.25 * h * stiffness + 0.5 * damping);
    const double rest =
        -h * (stiffness * (gradient.value - 0.25 * h * speedAtGuess) + 0.5 * damping * speedAtStart);
    Row row;
    row.give = 1.0 / perSpeed;
    row.target = rest / perSpeed;
    row.most = law.most * h;
    add(system, gradient, gradient, local(law.a), local(law.b), row);
}

void RowWriter::addSpring(RowSystem& system, std::uint32_t index, const std::vector<Triple>& middle,
                          const std::vector<Triple>& start, const std::vector<Triple>& guess,
                          double h) const {
    const Law& law = scene_.laws[index];
    const auto gradientAt = [&](const Law& which) {
        return gradientOf(which.measure, middle[local(law.a)], middle[local(law.b)]);
    };
    const auto addRow = [&](const Gradient& gradient) {
        addSpringRow(system, law, gradient, rate(gradient, law, start), rate(gradient, law, guess), h);
    };
    const Gradient x = gradientAt(law);
    if (!law.isPoint) return addRow(x);
    // Uses the principal axes of the point's inverse mass, in which impulse and velocity change are parallel.
    const Gradient y = gradientAt(scene_.laws[index + 1]);
    const double xx = give(x, x, law), xy = give(x, y, law), yy = give(y, y, law);
    const Turn axis{0.5 * std::atan2(2.0 * xy, xx - yy)};
    addRow(combined(axis.cos, x, axis.sin, y));
    addRow(combined(-axis.sin, x, axis.cos, y));
}

}  // namespace plumb::reference
