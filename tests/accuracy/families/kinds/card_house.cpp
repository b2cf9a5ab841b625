// A house of cards: pairs of cards that lean at each other, a card across from each tip to the next, and the
// next level on these.
//
// Statics lets every member stand. About its foot, the weight W of a leaning card (length L, thickness t) and
// the load P on its tip are balanced by its partner's push N: N L cos(lean) = (W / 2 + P) (L sin(lean) - t
// cos(lean)). So the foot needs a friction of N / (W + P) < tan(lean) - t / L. Half of the houses are built
// as people build them, with tips that are apart or in each other by some millimeters: then lean is that at
// which the tips meet, as the feet stay where they are.

#include <algorithm>
#include <cmath>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

Blueprint makeCardHouse(Random& random) {
    constexpr float kLength = 1.0f;  // m
    Blueprint plan;
    plan.seconds = 30.0;
    const int levels = 2 + static_cast<int>(random.below(5));
    const float lean = random.between(0.2f, 0.35f);
    const float thickness = random.between(0.02f, 0.06f), gap = random.between(0.0f, 0.12f);
    const float tipGap = random.below(2) == 0 ? 0.0f : random.between(-0.01f, 0.04f);
    const float settled = std::asin(std::sin(lean) + 0.5f * tipGap / kLength);
    constexpr float kMargin = 1.1f;  // over the friction that statics asks for
    const float least = std::max(0.4f, kMargin * (std::tan(settled) - thickness / kLength));
    const float friction = random.between(least, 0.9f);
    const Material paper{.density = random.between(20.0f, 500.0f), .friction = friction};
    plan.addFloor({.friction = friction});

    const float height = kLength * std::cos(lean) + thickness * std::sin(lean);  // of a leaning card
    // From the middle of a pair to that of a card.
    const float reach = 0.5f * (kLength * std::sin(lean) + thickness * std::cos(lean) + tipGap);
    const float pitch = 4.0f * reach + gap;  // from the middle of a pair to that of the next
    const Outline card = scenes::box({0.5f * thickness, 0.5f * kLength});
    // Tips carry a deck at a card's thickness from its ends, so it may be shorter by half of that.
    const float missing = random.between(0.0005f, 0.5f * thickness * std::cos(lean));
    const Outline deck = scenes::box({0.5f * pitch - missing, 0.5f * thickness});
    const float clearance = random.below(2) == 0 ? 0.0f : random.between(0.0f, 0.002f);  // between levels
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
    // Tips that are 4 cm apart let a level down by 2 cm * tan(0.4), and six levels by less than a tenth of
    // this.
    plan.goals.push_back(staysWithin(cards, 0.25));
    plan.goals.push_back(sleeps());
    return plan;
}

}  // namespace plumb::families
