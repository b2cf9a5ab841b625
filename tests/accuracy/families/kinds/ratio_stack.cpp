// Stacks of boxes with different masses and sizes.
//
// Every stack is statically stable: at each face between two boxes, and between the lowest box and the
// floor, the center of mass of all boxes above is inside the face by 30 % of its half width. There are no
// sideways forces, so any friction is enough. Contacts may sink by a slop (5 mm) on one side, which tilts a
// face of 0.4 m by 1/80. So the height of a stack is limited to 12 times its narrowest face: three such tilts
// in one direction then move its top by half a face. The top may sink by one slop per box.

#include <algorithm>
#include <cmath>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

namespace {

constexpr float kInside = 0.7f;  // maximum offset of the center of mass above a face, ratio to its half width
constexpr float kSlender = 12.0f;  // maximum ratio of height to narrowest face

struct Block {
    float halfWidth = 0.5f;  // half the width, m
    float halfHeight = 0.25f;
    float x = 0.0f;
    float mass = 1.0f;  // kg
};

/// True if the stack is statically stable with the margin kInside.
bool stands(const std::vector<Block>& stack) {
    float mass = 0.0f, moment = 0.0f;  // of all boxes above
    for (std::size_t i = stack.size(); i-- > 0;) {
        const Block& block = stack[i];
        mass += block.mass;
        moment += block.mass * block.x;
        float low = block.x - block.halfWidth, high = block.x + block.halfWidth;
        if (i > 0) {
            low = std::max(low, stack[i - 1].x - stack[i - 1].halfWidth);
            high = std::min(high, stack[i - 1].x + stack[i - 1].halfWidth);
        }
        const float half = 0.5f * (high - low);
        if (half < 0.15f || std::fabs(moment / mass - 0.5f * (low + high)) > kInside * half) return false;
    }
    return true;
}

/// Returns the mass of box i, 1 to `ratio`, for one of five distributions.
float massOf(std::uint32_t rule, std::size_t i, std::size_t count, float ratio, Random& random) {
    const float part = static_cast<float>(i) / static_cast<float>(count - 1);
    switch (rule) {
        case 0: return std::pow(ratio, part);            // increasing upwards
        case 1: return std::pow(ratio, 1.0f - part);     // decreasing upwards
        case 2: return i + 1 == count ? ratio : 1.0f;    // one heavy box on top
        case 3: return i % 2 == 0 ? 1.0f : ratio;        // alternating
        default: return std::pow(ratio, random.unit());  // random
    }
}

std::vector<Block> drawStack(Random& random) {
    std::vector<Block> stack(3 + random.below(18));
    const float ratio = std::pow(200.0f, random.unit());
    const std::uint32_t rule = random.below(5);
    const float widest = random.between(0.25f, 0.8f), unlike = random.between(0.0f, 0.5f);
    const float flat = random.between(0.35f, 1.0f);
    float narrowest = widest;
    for (std::size_t i = 0; i < stack.size(); ++i) {
        Block& block = stack[i];
        block.halfWidth = std::max(widest * (1.0f - unlike * random.unit()), 0.2f);
        block.halfHeight = block.halfWidth * flat;
        block.x = random.between(-0.25f, 0.25f) * block.halfWidth;
        block.mass = massOf(rule, i, stack.size(), ratio, random);
        narrowest = std::min(narrowest, block.halfWidth);
    }
    float height = 0.0f;
    for (const Block& block : stack) height += 2.0f * block.halfHeight;
    const float lower = std::min(kSlender * 2.0f * narrowest / height, 1.0f);
    for (Block& block : stack) block.halfHeight *= lower;
    while (!stands(stack))
        for (Block& block : stack) block.x *= 0.7f;
    return stack;
}

}  // namespace

Blueprint makeRatioStack(Random& random) {
    Blueprint plan;
    const float friction = random.between(0.1f, 1.0f), unit = random.between(0.2f, 20.0f);  // ratio; mass, kg
    plan.addFloor({.friction = friction});
    std::vector<std::uint32_t> boxes;
    float top = 0.0f;
    for (const Block& block : drawStack(random)) {
        const float area = 4.0f * block.halfWidth * block.halfHeight;
        boxes.push_back(plan.addDynamic(scenes::box({block.halfWidth, block.halfHeight}),
                                        {block.x, top + block.halfHeight},
                                        {.density = unit * block.mass / area, .friction = friction}));
        top += 2.0f * block.halfHeight;
    }
    plan.layers = static_cast<int>(boxes.size());
    plan.goals.push_back(staysWithin(boxes, 0.05 + 0.005 * static_cast<double>(boxes.size())));
    plan.goals.push_back(overlapsAtMost(0.02));  // four slops
    plan.goals.push_back(sleeps());
    return plan;
}

}  // namespace plumb::families
