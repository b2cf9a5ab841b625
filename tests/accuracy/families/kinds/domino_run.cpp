// Dominoes in a row, the first of which is pushed over.
//
// The first one rotates about its lower edge with more energy than its center needs to pass over that
// edge. The wave must then continue even if every hit takes all speed: a domino of height h and
// thickness t that leans on the next one across a gap g touches it at the height y = root (h^2 - g^2).
// About its edge, its weight W pushes with N (y + f g) = W (g - t) / 2 or more against friction f, and
// the next one tips if N (y - f t) > W t / 2. That is g > t (1 + (y + f g) / (y - f t)), and members
// keep a margin of 5 %. In a leaning row at rest the cosine of the angle to the vertical is t / (t + g).

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

namespace {

/// For the goals: the step at which each domino finally passed over its edge.
struct Falls {
    std::vector<std::uint32_t> dominoes;
    double angle = 0.0;  ///< rad: larger angles count as fallen
    std::vector<int> steps;

    void look(const Stage& stage, int step) {
        if (step == 0) steps.assign(dominoes.size(), 0);
        for (std::size_t i = 0; i < dominoes.size(); ++i) {
            const bool over = stage.has(dominoes[i]) && stage.turnOf(dominoes[i]) < -angle;
            steps[i] = !over ? 0 : steps[i] == 0 ? step : steps[i];
        }
    }
};

Goal allFall(const std::shared_ptr<Falls>& falls) {
    return {"all fall",
            [falls](const Stage& stage) {
                double standing = 0.0;
                for (const std::uint32_t domino : falls->dominoes) {
                    const bool fallen = stage.has(domino) && stage.turnOf(domino) < -falls->angle;
                    standing += takesPart(stage, domino) && !fallen ? 1.0 : 0.0;
                }
                return standing;
            },
            0.0};
}

Goal fallInOrder(const std::shared_ptr<Falls>& falls) {
    return {"fall in order",
            [falls](const Stage&) {
                double early = 0.0;
                for (std::size_t i = 1; i < falls->steps.size(); ++i) {
                    const int before = falls->steps[i - 1], step = falls->steps[i];
                    early += before > 0 && step > 0 && step < before ? 1.0 : 0.0;
                }
                return early;
            },
            0.0};
}

}  // namespace

Blueprint makeDominoRun(Random& random) {
    Blueprint plan;
    const int count = 8 + static_cast<int>(random.below(23));
    const float height = 0.2f * std::pow(10.0f, random.unit());  // m, 0.2 to 2
    const float thickness = height * random.between(0.06f, 0.2f);
    // Dominoes slide along each other and grip the floor.
    // The friction of a pair is the root of the product.
    const float friction = random.between(0.1f, 0.4f), foot = random.between(0.5f, 0.9f);
    const Material tile{.density = random.between(0.5f, 100.0f), .friction = friction};
    constexpr float kWidest = 0.55f;  // gap over height
    const float touch = height * std::sqrt(1.0f - kWidest * kWidest);
    const float lever = (touch + friction * kWidest * height) / (touch - friction * thickness);
    const float gap = random.between(1.05f * thickness * (1.0f + lever), kWidest * height);
    const float push = random.between(2.0f, 4.0f);
    plan.addFloor({.friction = foot * foot / friction});

    auto falls = std::make_shared<Falls>();
    const float pitch = thickness + gap;
    // The final angles of a row at rest, with its last one flat; goals require half of the steepest one's
    // rotation.
    falls->angle = 0.5 * std::acos(static_cast<double>(thickness / pitch));
    for (int i = 0; i < count; ++i)
        falls->dominoes.push_back(plan.addDynamic(scenes::box({0.5f * thickness, 0.5f * height}),
                                                  {static_cast<float>(i) * pitch, 0.5f * height}, tile));
    // About its edge: I = m d^2 / 3, and the center rises by (d - height) / 2, where d is the diagonal.
    const float diagonal = std::sqrt(height * height + thickness * thickness);
    const float spin = push * std::sqrt(3.0f * 10.0f * (diagonal - height)) / diagonal;
    BodySetup& first = plan.bodies[falls->dominoes[0]].setup;
    first.spin = -spin;
    first.velocity = spin * Vec2{0.5f * height, 0.5f * thickness};
    // No wave is slower than half of root (g height); then they settle.
    plan.seconds = 2.0 +
                   2.0 * static_cast<double>(static_cast<float>(count) * pitch / std::sqrt(10.0f * height)) +
                   3.0 * std::sqrt(static_cast<double>(height));
    plan.drive = [falls](Stage& stage, int step) { falls->look(stage, step); };
    plan.goals.push_back(allFall(falls));
    plan.goals.push_back(fallInOrder(falls));
    return plan;
}

}  // namespace plumb::families
