#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include "physics/model/joints.hpp"
#include "tests/accuracy/reference/reference.hpp"
#include "tests/physics/support/world_of_bodies.hpp"

namespace plumb::reference {

using physics::BodyId;
using physics::BodyKind;
using physics::Playground;

/// Solves, and says why not.
inline Answer solved(const physics::World& world, double seconds, const Options& options = {}) {
    auto answer = solveReference(world, seconds, options);
    EXPECT_TRUE(answer.ok()) << (answer.ok() ? "" : answer.error().text());
    return answer.ok() ? *answer : Answer{};
}

inline BodyAnswer of(const Answer& answer, BodyId body) {
    for (const BodyAnswer& one : answer.bodies) {
        if (one.body == body) return one;
    }
    ADD_FAILURE() << "no such body in the answer";
    return {};
}

/// The true error is no larger than the stated one, which is no more than a hundred times the true one. What
/// is exact but for rounding may say so with some nanometres.
inline void expectHonest(double truth, double stated, double least = 1.0e-9) {
    EXPECT_LE(truth, stated);
    EXPECT_LE(stated, std::max(100.0 * truth, least));
}

inline double farFrom(const BodyAnswer& body, double x, double y) {
    return std::hypot(body.centre.x - x, body.centre.y - y);
}

/// The sum of the forces (N) between two bodies along their normals.
inline double forceBetween(const Answer& answer, BodyId a, BodyId b) {
    double force = 0.0;
    for (const ContactAnswer& contact : answer.contacts) {
        if ((contact.a == a && contact.b == b) || (contact.a == b && contact.b == a)) force += contact.force;
    }
    return force;
}

}  // namespace plumb::reference
