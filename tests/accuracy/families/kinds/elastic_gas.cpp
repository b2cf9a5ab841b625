// Discs and boxes that bounce off each other and off walls without friction and gravity.
//
// Energy: an elastic impact conserves energy for any contact normal. But impacts slower
// than Settings::bounceSpeed (1 m/s in all engines here) are not elastic. At a mean speed v
// the approach speed is below 1 m/s in a fraction 1 / (2 v^2) of all impacts (flux of a Maxwell
// gas); each loses m (1 m/s)^2 / 8 on average: at the lowest speed here, 4 m/s, 5e-4 of a
// body's energy in each of some tens of impacts. So a loss of 5 % is allowed if bodies move by
// at most a quarter of the smallest body's size per step. Faster bodies overlap deeply, or
// with several others, before a contact is detected; then half of the energy must remain. Energy
// must never grow. Momentum: without walls linear and angular momentum are conserved.

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

namespace {

struct Molecule {
    std::uint32_t body = 0;
    double mass = 0.0;     // kg
    double inertia = 0.0;  // moment of inertia, kg m2
};

struct Book {
    double energy = 0.0;  // total kinetic energy, J
    double x = 0.0;       // total momentum, kg m/s
    double y = 0.0;
    double around = 0.0;  // total angular momentum about the origin, kg m2/s
    double size = 0.0;    // sum of the magnitudes of all momenta, kg m/s
    double reach = 0.0;   // sum of the magnitudes of all angular momenta, kg m2/s
};

Book bookOf(const Stage& stage, const std::vector<Molecule>& gas) {
    Book book;
    for (const Molecule& one : gas) {
        if (!stage.has(one.body)) continue;
        const Vec2 velocity = stage.velocityOf(one.body);
        const auto vx = static_cast<double>(velocity.x), vy = static_cast<double>(velocity.y);
        const auto spin = static_cast<double>(stage.spinOf(one.body));
        const scenes::Point at = stage.positionOf(one.body);
        book.energy += 0.5 * (one.mass * (vx * vx + vy * vy) + one.inertia * spin * spin);
        book.x += one.mass * vx;
        book.y += one.mass * vy;
        book.around += one.mass * (at.x * vy - at.y * vx) + one.inertia * spin;
        book.size += one.mass * std::hypot(vx, vy);
        book.reach += one.mass * std::hypot(vx, vy) * std::hypot(at.x, at.y);
    }
    return book;
}

}  // namespace

Blueprint makeElasticGas(Random& random) {
    Blueprint plan;
    plan.gravity = {};
    plan.seconds = 5.0;
    const bool walled = random.below(2) == 0;
    const int columns = 2 + static_cast<int>(random.below(6));
    const float unlike = random.between(0.0f, 0.6f), density = random.between(0.2f, 20.0f);
    const float speed = 4.0f * std::pow(10.0f, random.unit());  // mean speed, m/s
    // Radius of the largest body, m. The radius of the smallest is 0.7 to 4 times (fast) or 4 to 10 times the
    // distance that a body of mean speed travels in a step.
    const bool fast = random.below(2) == 0;
    const float share = fast ? random.between(0.7f, 4.0f) : random.between(4.0f, 10.0f);
    const float radius = share * speed * kStep / (1.0f - unlike);
    const float spacing = radius * random.between(2.5f, 6.0f);
    const float boxes = random.unit();  // fraction of bodies that are boxes
    const Material hard{.density = density, .friction = 0.0f, .bounciness = 1.0f};
    const float half = 0.5f * static_cast<float>(columns) * spacing;

    std::vector<Molecule> gas;
    std::vector<std::uint32_t> all;
    for (int i = 0; i < columns * columns; ++i) {
        const Vec2 at{(static_cast<float>(i % columns) + 0.5f) * spacing - half,
                      (static_cast<float>(i / columns) + 0.5f) * spacing - half};
        const float size = radius * (1.0f - unlike * random.unit());
        const float heading = random.between(0.0f, kTau);
        // Without walls the bodies move towards the center, so that they collide.
        Vec2 velocity{speed * std::cos(heading), speed * std::sin(heading)};
        if (!walled) velocity = 0.3f * velocity - (speed / std::max(half, 0.1f)) * at;
        const bool isBox = random.unit() < boxes;
        const Vec2 sides{0.8f * size, random.between(0.4f, 0.6f) * size};
        const std::uint32_t body =
            plan.add({.position = at, .angle = random.between(0.0f, kTau), .velocity = velocity},
                     isBox ? scenes::box(sides) : scenes::circle(size), hard);
        const auto x = static_cast<double>(sides.x), y = static_cast<double>(sides.y);
        const auto r = static_cast<double>(size);
        const double mass = static_cast<double>(density) * (isBox ? 4.0 * x * y : 3.141592653589793 * r * r);
        gas.push_back({body, mass, isBox ? mass * (x * x + y * y) / 3.0 : 0.5 * mass * r * r});
        all.push_back(body);
    }
    if (walled) {
        for (const float side : {-1.0f, 1.0f}) {
            plan.addStatic(scenes::box({1.0f, half + 2.0f}), {side * (half + 1.0f), 0.0f}, hard);
            plan.addStatic(scenes::box({half + 2.0f, 1.0f}), {0.0f, side * (half + 1.0f)}, hard);
        }
        plan.goals.push_back(staysIn(all, {-half, -half}, {half, half}));
    }
    auto start = std::make_shared<Book>();
    plan.drive = [start, gas](Stage& stage, int step) {
        if (step == 0) *start = bookOf(stage, gas);
    };
    plan.goals.push_back({"keeps its energy",
                          [start, gas](const Stage& stage) {
                              return std::fabs(bookOf(stage, gas).energy / start->energy - 1.0);
                          },
                          fast ? 0.5 : 0.05});
    plan.goals.push_back(
        {"gains no energy",
         [start, gas](const Stage& stage) { return bookOf(stage, gas).energy / start->energy - 1.0; }, 1e-3});
    if (walled) return plan;
    plan.goals.push_back({"keeps its momentum",
                          [start, gas](const Stage& stage) {
                              const Book end = bookOf(stage, gas);
                              return std::hypot(end.x - start->x, end.y - start->y) / start->size;
                          },
                          1e-4});
    plan.goals.push_back({"keeps its angular momentum",
                          [start, gas](const Stage& stage) {
                              const Book end = bookOf(stage, gas);
                              return std::fabs(end.around - start->around) /
                                     std::max(start->reach, end.reach);
                          },
                          5e-3});
    return plan;
}

}  // namespace plumb::families
