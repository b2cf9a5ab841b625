// A pit in which bodies are created, destroyed, teleported, pushed
// and get new masses, with pauses in which all bodies fall asleep.
//
// Bodies are created at, or teleported to, random positions in the upper half of a closed pit, possibly
// overlapping others. The pit is at most a third full, so no body may be forced out of it.

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

namespace {

struct Pit {
    float half = 3.0f;  // half the width, m
    float height = 8.0f;
    float size = 0.3f;       // maximum radius of a body, m
    float speed = 5.0f;      // maximum speed of pushes, m/s
    float rate = 0.2f;       // mean number of changes per step
    float heaviest = 10.0f;  // maximum mass ratio
    std::uint32_t maxCount = 40;
    Material stuff;
};

BodyPlan itemOf(Random& random, const Pit& pit) {
    BodyPlan plan;
    const float size = pit.size * random.between(0.4f, 1.0f), margin = pit.size + 0.01f;
    plan.setup.position = {random.between(-pit.half + margin, pit.half - margin),
                           random.between(0.5f * pit.height, pit.height - margin)};
    plan.setup.angle = random.between(0.0f, kTau);
    plan.setup.bullet = random.below(8) == 0;
    const bool round = random.below(2) == 0;
    plan.shapes.push_back(
        {round ? scenes::circle(size) : scenes::box({0.8f * size, 0.6f * size}), pit.stuff});
    return plan;
}

void change(Stage& stage, Random& random, const Pit& pit, std::vector<std::uint32_t>& there) {
    const std::uint32_t kind = random.below(6);
    if (there.empty() || (kind == 0 && there.size() < pit.maxCount)) {
        there.push_back(stage.spawn(itemOf(random, pit)));
        return;
    }
    const std::size_t which = random.below(static_cast<std::uint32_t>(there.size()));
    const std::uint32_t body = there[which];
    const float heading = random.between(0.0f, kTau), speed = pit.speed * random.unit();
    const BodyPlan drawn = itemOf(random, pit);
    switch (kind) {
        case 1:
            stage.destroy(body);
            there.erase(there.begin() + static_cast<std::ptrdiff_t>(which));
            return;
        case 2: return stage.teleport(body, drawn.setup.position, drawn.setup.angle);
        case 3: return stage.setMass(body, 0.1f * std::pow(pit.heaviest, random.unit()));
        case 4: return stage.setSpin(body, random.between(-5.0f, 5.0f));
        default: return stage.setVelocity(body, {speed * std::cos(heading), speed * std::sin(heading)});
    }
}

}  // namespace

Blueprint makeChurn(Random& random) {
    constexpr int kPhase = 90;  // phases of 90 steps with changes alternate with 90 steps without
    Blueprint plan;
    plan.closed = false;
    plan.seconds = 8.0;
    Pit pit;
    pit.half = random.between(1.5f, 4.0f);
    pit.height = random.between(6.0f, 12.0f);
    // The maximum size is such that all bodies together fill at most a third of the pit.
    pit.maxCount = 10 + random.below(31);
    pit.size =
        std::min(std::sqrt(2.0f * pit.half * pit.height / (9.5f * static_cast<float>(pit.maxCount))), 0.6f);
    pit.speed = random.between(1.0f, 20.0f);
    pit.rate = 0.02f * std::pow(50.0f, random.unit());
    pit.heaviest = std::pow(100.0f, random.unit());
    pit.stuff = {.friction = random.between(0.0f, 1.0f), .bounciness = random.between(0.0f, 0.6f)};
    for (const float side : {-1.0f, 1.0f}) {
        plan.addStatic(scenes::box({0.5f, 0.5f * pit.height + 1.0f}),
                       {side * (pit.half + 0.5f), 0.5f * pit.height}, pit.stuff);
        plan.addStatic(scenes::box({pit.half + 1.0f, 0.5f}),
                       {0.0f, (0.5f + 0.5f * side) * pit.height + 0.5f * side}, pit.stuff);
    }
    struct State {
        Random random;
        std::vector<std::uint32_t> there;
    };
    auto state = std::make_shared<State>();
    const std::uint64_t seed = random.next64();
    plan.drive = [=](Stage& stage, int step) {
        if (step == 0) *state = {Random::seeded(seed), {}};
        if (step / kPhase % 2 == 1) return;
        for (float changes = pit.rate; changes > 0.0f; changes -= 1.0f)
            if (state->random.unit() < changes) change(stage, state->random, pit, state->there);
    };
    plan.goals.push_back({"nothing leaves the pit",
                          [=](const Stage& stage) {
                              double outside = 0.0;
                              for (const std::uint32_t body : state->there) {
                                  if (!stage.has(body)) continue;
                                  const scenes::Point at = stage.positionOf(body);
                                  const bool in = std::fabs(at.x) <= static_cast<double>(pit.half) &&
                                                  at.y >= 0.0 && at.y <= static_cast<double>(pit.height);
                                  outside += in ? 0.0 : 1.0;
                              }
                              return outside;
                          },
                          0.0});
    return plan;
}

}  // namespace plumb::families
