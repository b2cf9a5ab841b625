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

/// Solves a world; the test fails with the error text if that is impossible.
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

/// Expects that the true error does not exceed the stated one, and that the stated one is at most a hundred
/// times the true one. For solutions that are exact up to rounding it may be up to `least`.
inline void expectHonest(double truth, double stated, double least = 1.0e-9) {
    EXPECT_LE(truth, stated);
    EXPECT_LE(stated, std::max(100.0 * truth, least));
}

inline double farFrom(const BodyAnswer& body, double x, double y) {
    return std::hypot(body.centre.x - x, body.centre.y - y);
}

/// Sum of the normal forces between two bodies, N.
inline double forceBetween(const Answer& answer, BodyId a, BodyId b) {
    double force = 0.0;
    for (const ContactAnswer& contact : answer.contacts) {
        if ((contact.a == a && contact.b == b) || (contact.a == b && contact.b == a)) force += contact.force;
    }
    return force;
}

}  // namespace plumb::reference
