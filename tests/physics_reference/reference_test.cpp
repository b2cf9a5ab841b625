#include <gtest/gtest.h>

#include "physics/joints.hpp"
#include "tests/accuracy/reference/reference.hpp"
#include "tests/physics/world_of_bodies.hpp"

namespace plumb::reference {
namespace {

using physics::BodyId;
using physics::Playground;
using physics::ShapeDefinition;

/// Solves, and says why not.
Answer solved(const physics::World& world, double seconds, const Options& options = {}) {
    auto answer = solveReference(world, seconds, options);
    EXPECT_TRUE(answer.ok()) << (answer.ok() ? "" : answer.error().text());
    return answer.ok() ? *answer : Answer{};
}

const BodyAnswer& of(const Answer& answer, BodyId body) {
    for (const BodyAnswer& one : answer.bodies) {
        if (one.body == body) return one;
    }
    ADD_FAILURE() << "no such body in the answer";
    static const BodyAnswer none;
    return none;
}

/// The true error is below the stated one, and that is below a hundred times the true one or the least that
/// counts.
void expectHonest(double truth, double stated, double least = 1.0e-9) {
    EXPECT_LE(truth, stated);
    EXPECT_LE(stated, std::max(100.0 * truth, least));
}

double farFrom(const BodyAnswer& body, double x, double y) {
    return std::hypot(body.centre.x - x, body.centre.y - y);
}

TEST(Reference, freeFallIsExact) {
    Playground scene;
    const BodyId ball = scene.ball({0.0, 100.0});
    const Answer answer = solved(scene.world, 2.0);
    EXPECT_NEAR(of(answer, ball).centre.y, 80.0, 1.0e-11);
    expectHonest(farFrom(of(answer, ball), 0.0, 80.0), answer.error);
}

TEST(Reference, aStackCarriesWhatIsAboveEachLevel) {
    Playground scene;
    scene.floor();
    std::vector<BodyId> crates;
    for (int i = 0; i < 20; ++i) crates.push_back(scene.crate({0.0, 0.5 + i}));
    const Answer answer = solved(scene.world, 1.0);
    for (std::size_t level = 0; level < 20; ++level) {
        double force = 0.0;
        for (const ContactAnswer& contact : answer.contacts) {
            if (contact.b == crates[level] && (level == 0 || contact.a == crates[level - 1])) force += contact.force;
        }
        EXPECT_NEAR(force, 10.0 * static_cast<double>(20 - level), 1.0e-6) << level;
    }
    expectHonest(farFrom(of(answer, crates.back()), 0.0, 19.5), answer.error);
}

}  // namespace
}  // namespace plumb::reference
