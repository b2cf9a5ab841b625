// A house of cards: pairs of cards that lean against each other,
// horizontal cards from tip to tip, and the next level on these.
//
// Every house is statically stable. Torque balance of a leaning card (weight W, length L, thickness t, load P
// on its tip) about its foot gives the force N of the other card of its pair: N L cos(lean) = (W / 2 + P) (L
// sin(lean) - t cos(lean)). So a friction of N / (W + P) < tan(lean) - t / L at the foot is enough. Half of
// the houses are inexact: tips are apart or overlap by some millimeters; `lean` is then the angle at which
// the tips touch while the feet stay in place.

#include <algorithm>
#include <cmath>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

Blueprint makeCardHouse(Random& random) {
    constexpr float kLength = 1.0f;  // of a card, m
    Blueprint plan;
    plan.seconds = 30.0;
    const int levels = 2 + static_cast<int>(random.below(5));
    const float lean = random.between(0.2f, 0.35f);
    const float thickness = random.between(0.02f, 0.06f), gap = random.between(0.0f, 0.12f);
    const float tipGap = random.below(2) == 0 ? 0.0f : random.between(-0.01f, 0.04f);
    const float settled = std::asin(std::sin(lean) + 0.5f * tipGap / kLength);
    constexpr float kMargin = 1.1f;  // minimum ratio of the friction to that required by statics
    const float least = std::max(0.4f, kMargin * (std::tan(settled) - thickness / kLength));
    const float friction = random.between(least, 0.9f);
    const Material paper{.density = random.between(20.0f, 500.0f), .friction = friction};
    plan.addFloor({.friction = friction});

    const float height = kLength * std::cos(lean) + thickness * std::sin(lean);  // of a leaning card, m
    // Horizontal distance from the center of a pair to the center of its card, m.
    const float reach = 0.5f * (kLength * std::sin(lean) + thickness * std::cos(lean) + tipGap);
    const float pitch = 4.0f * reach + gap;  // distance between the centers of neighbouring pairs, m
    const Outline card = scenes::box({0.5f * thickness, 0.5f * kLength});
    // Tips support a horizontal card within one thickness of its
    // ends, so this card may be shorter by half a thickness.
    const float missing = random.between(0.0005f, 0.5f * thickness * std::cos(lean));
    const Outline deck = scenes::box({0.5f * pitch - missing, 0.5f * thickness});
    // Vertical gap between levels, m.
    const float clearance = random.below(2) == 0 ? 0.0f : random.between(0.0f, 0.002f);
    std::vector<std::uint32_t> cards;
    float base = 0.0f;
    for (int pairs = levels; pairs > 0; --pairs) {
        const float first = -0.5f * static_cast<float>(pairs - 1) * pitch;
        for (int i = 0; i < pairs; ++i) {
            const float middle = first + static_cast<float>(i) * pitch;
            for (const float side : {-1.0f, 1.0f})
                cards.push_back(
                    plan.addDynamic(card, {middle + side * reach, base + 0.5f * height}, paper, side * lean));
        }
        base += height + clearance;
        for (int i = 0; i + 1 < pairs; ++i)
            cards.push_back(plan.addDynamic(
                deck, {first + (static_cast<float>(i) + 0.5f) * pitch, base + 0.5f * thickness}, paper));
        base += thickness + clearance;
    }
    // Tips that are 4 cm apart at the start lower a level by 2 cm
    // * tan(0.4); six levels together sink by much less than 0.25 m.
    plan.goals.push_back(staysWithin(cards, 0.25));
    plan.goals.push_back(sleeps());
    return plan;
}

}  // namespace plumb::families
