#include <algorithm>
#include <cmath>

#include "tests/accuracy/stability/lab.hpp"
#include "tests/accuracy/stability/maps.hpp"

// Scenes of the stability map with motion whose solution is known, and with fast spins, overlaps, presses.

namespace plumb::stability {

namespace {

constexpr double kSeconds = 10.0;

Vec2 at(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

const Outline kCrate = scenes::box({0.5f, 0.5f});

/// A ball that falls 2 m and bounces. Its error is the largest deviation of the first
/// three heights from the expected heights, relative to 2 m.
Figures bouncing(const Terms& terms, double bounciness) {
    constexpr double kHeight = 2.0;
    const Material rubber{.friction = 0.0f, .bounciness = static_cast<float>(bounciness)};
    Lab lab{terms, {.size = 1.0, .extent = kHeight, .rests = false}};
    lab.floor(rubber);
    const BodyHandle ball = lab.add(scenes::circle(0.5f), at(0.0, kHeight + 0.5), rubber);
    double before = 0.0, wanted = kHeight, worst = 0.0, highest = 0.0;
    int bounces = 0;
    lab.run(kSeconds, [&](double) {
        const auto speed = static_cast<double>(lab.velocity(ball).y);
        if (before < 0.0 && speed >= 0.0 && bounces < 3) {
            ++bounces;
            wanted *= bounciness * bounciness;
            // Impacts slower than Settings::bounceSpeed do not bounce, by design.
            const auto least = static_cast<double>(lab.world().settings.bounceSpeed);
            const double rise = std::sqrt(2.0 * kGravity * wanted);
            if (bounciness <= 0.0 || rise > least * bounciness) {
                highest = lab.y(ball) - 0.5 + speed * speed / (2.0 * kGravity);
                worst = std::max(worst, std::fabs(highest - wanted) / kHeight);
            }
        }
        before = speed;
    });
    lab.setOff(bounces > 0 ? worst : 1.0);
    return lab.figures();
}

/// A kinematic press that moves down until the fraction
/// `left` of a crate's height is left, waits, and moves up.
Figures press(double quality, double left, double speed) {
    const double step = 1.0 / 60.0;
    Lab lab{{.quality = quality},
            {.size = 1.0,
             .extent = 2.0,
             .mostSpeed = speed + 9.0,
             .driven = true,
             .rests = false,
             .overlapped = true}};
    lab.floor();
    for (const double x : {-1.1, 0.0, 1.1}) lab.add(kCrate, at(x, 0.5));
    const double way = 2.0 - left;
    const BodyHandle plate = lab.addKinematic(scenes::box({5.0f, 0.5f}), at(0.0, 2.5));
    const double down = std::max(1.0, std::round(way / speed / step)) * step;
    lab.setVelocity(plate, at(0.0, -way / down));
    lab.run(down);
    lab.setVelocity(plate, {});
    lab.run(1.0);
    lab.setVelocity(plate, at(0.0, 5.0));
    lab.run(5.0);
    return lab.figures();
}

}  // namespace

Figures bounce(double quality, double bounciness) { return bouncing({.quality = quality}, bounciness); }

Figures bounceAtStep(double step, double bounciness) { return bouncing({.step = step}, bounciness); }

Figures slope(double quality, double friction) {
    constexpr double kAngle = 0.5, kTime = 3.0;  // rad, s
    const Material rough{.friction = static_cast<float>(friction)};
    Lab lab{{.quality = quality}, {.size = 1.0, .extent = 50.0, .rests = false}};
    lab.countHeightFrom(-50.0);
    const double sine = std::sin(kAngle), cosine = std::cos(kAngle);
    lab.addFixed(scenes::box({100.0f, 1.0f}), {}, rough, -kAngle);
    const Vec2 start = at(1.5 * sine, 1.5 * cosine);
    const BodyHandle crate = lab.add(kCrate, start, rough, -kAngle);
    lab.run(kTime);
    const double pull = std::max(kGravity * (sine - friction * cosine), 0.0);
    const double way = 0.5 * pull * kTime * kTime;
    const double gone = (lab.x(crate) - static_cast<double>(start.x)) * cosine -
                        (lab.y(crate) - static_cast<double>(start.y)) * sine;
    lab.setOff(std::fabs(gone - way) / std::max(way, 1.0));
    return lab.figures();
}

Figures spinOnFloor(double quality, double spin) {
    Lab lab{{.quality = quality}, {.size = 0.2, .extent = 2.0, .rests = false}};
    lab.floor({}, 1.0e5);
    const BodyHandle plank = lab.add(scenes::box({1.0f, 0.1f}), {0.0f, 1.5f});
    lab.setVelocity(plank, {}, spin);
    lab.run(kSeconds);
    return lab.figures();
}

/// A plank that spins among crates in a pit. The total energy must not grow.
Figures spinAmongCrates(double quality, double spin) {
    Lab lab{{.quality = quality}, {.size = 0.2, .extent = 10.0, .rests = false}};
    lab.countHeightFrom(-1000.0);
    lab.floor();
    for (const double side : {-1.0, 1.0}) lab.addFixed(scenes::box({5.0f, 100.0f}), at(11.0 * side, 100.0));
    for (int i = 0; i < 16; ++i) lab.add(kCrate, at(-4.5 + 3.0 * (i % 4), 0.5 + 1.0 * (i / 4)));
    const BodyHandle plank = lab.add(scenes::box({1.0f, 0.1f}), {0.0f, 5.5f});
    lab.setVelocity(plank, {}, spin);
    lab.run(kSeconds);
    return lab.figures();
}

Figures spawnedInOnePlace(double quality, double count) {
    const double far = 4.0 + std::sqrt(20.0 * count);
    Lab lab{{.quality = quality},
            {.size = 1.0, .extent = count, .mostSpeed = far, .rests = false, .overlapped = true}};
    lab.floor();
    for (int i = 0; i < static_cast<int>(count); ++i) lab.add(kCrate, {0.0f, 0.5f});
    lab.run(kSeconds);
    return lab.figures();
}

Figures crushed(double quality, double left) { return press(quality, left, 0.5); }
Figures crushedFast(double quality, double speed) { return press(quality, 0.5, speed); }

}  // namespace plumb::stability
