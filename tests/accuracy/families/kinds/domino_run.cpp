// A row of dominoes, the first of which is pushed over.
//
// The first domino starts with enough energy to rotate over its lower edge. The wave must then continue even
// if every impact stops the domino: a domino of height h and thickness t that leans on the next one across a
// gap g touches it at the height y = sqrt(h^2 - g^2). Its weight W pushes with a force N, N (y + f g) >= W (g
// - t) / 2, at friction f, and the next domino tips if N (y - f t) > W t / 2. So g > t (1 + (y + f g) / (y -
// f t)); all rows have a margin of 5 %. In a fallen row at rest the cosine of the angle to the vertical is t
// / (t + g).

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

namespace {

/// Records the step in which each domino fell for good. Used by the goals of the scene.
struct Falls {
    std::vector<std::uint32_t> dominoes;
    double angle = 0.0;  ///< angle above which a domino counts as fallen, rad
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
    // Low friction between dominoes, high friction with the
    // floor. The friction of a pair is the geometric mean.
    const float friction = random.between(0.1f, 0.4f), foot = random.between(0.5f, 0.9f);
    const Material tile{.density = random.between(0.5f, 100.0f), .friction = friction};
    constexpr float kWidest = 0.55f;  // maximum ratio of gap to height
    const float touch = height * std::sqrt(1.0f - kWidest * kWidest);
    const float lever = (touch + friction * kWidest * height) / (touch - friction * thickness);
    const float gap = random.between(1.05f * thickness * (1.0f + lever), kWidest * height);
    const float push = random.between(2.0f, 4.0f);
    plan.addFloor({.friction = foot * foot / friction});

    auto falls = std::make_shared<Falls>();
    const float pitch = thickness + gap;
    // At rest the dominoes lean at acos(t / pitch), except for the last
    // one, which lies flat. A domino counts as fallen at half this angle.
    falls->angle = 0.5 * std::acos(static_cast<double>(thickness / pitch));
    for (int i = 0; i < count; ++i)
        falls->dominoes.push_back(plan.addDynamic(scenes::box({0.5f * thickness, 0.5f * height}),
                                                  {static_cast<float>(i) * pitch, 0.5f * height}, tile));
    // Rotation about the lower edge: I = m d^2 / 3, and the
    // center rises by (d - height) / 2; d is the diagonal.
    const float diagonal = std::sqrt(height * height + thickness * thickness);
    const float spin = push * std::sqrt(3.0f * 10.0f * (diagonal - height)) / diagonal;
    BodySetup& first = plan.bodies[falls->dominoes[0]].setup;
    first.spin = -spin;
    first.velocity = spin * Vec2{0.5f * height, 0.5f * thickness};
    // Time for a wave with a speed of at least sqrt(g height) / 2, and for the dominoes to come to rest.
    plan.seconds = 2.0 +
                   2.0 * static_cast<double>(static_cast<float>(count) * pitch / std::sqrt(10.0f * height)) +
                   3.0 * std::sqrt(static_cast<double>(height));
    plan.drive = [falls](Stage& stage, int step) { falls->look(stage, step); };
    plan.goals.push_back(allFall(falls));
    plan.goals.push_back(fallInOrder(falls));
    return plan;
}

}  // namespace plumb::families
