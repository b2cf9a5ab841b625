// Family "pyramid": pyramids of bricks.
//
// Statics: each brick lies on two others with equal parts of its width, and all forces are vertical, so any
// friction is enough. Overlaps: each row may sink into the row below by a slop (5 mm).

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

Blueprint makePyramid(Random& random) {
    Blueprint plan;
    const float friction = random.between(0.3f, 0.9f);
    const Vec2 half{random.between(0.2f, 0.8f), random.between(0.2f, 0.4f)};
    const float pitch = 2.0f * half.x * random.between(1.01f, 1.3f);  // m, between centers of neighbours
    const float unlike = random.between(1.0f, 2.0f);                  // maximum ratio of densities
    const std::uint32_t rows = 4 + random.below(17);
    plan.addFloor({.friction = friction});
    std::vector<std::uint32_t> bricks;
    for (std::uint32_t row = 0; row < rows; ++row) {
        const std::uint32_t count = rows - row;
        const float first = -0.5f * pitch * static_cast<float>(count - 1);
        for (std::uint32_t i = 0; i < count; ++i) {
            const Vec2 place{first + pitch * static_cast<float>(i),
                             half.y * (2.0f * static_cast<float>(row) + 1.0f)};
            const Material material{.density = random.between(1.0f, unlike), .friction = friction};
            bricks.push_back(plan.addDynamic(scenes::box(half), place, material));
        }
    }
    plan.layers = static_cast<int>(rows);
    plan.goals.push_back(staysWithin(bricks, 0.05 + 0.005 * static_cast<double>(rows)));
    plan.goals.push_back(overlapsAtMost(0.02));  // four slops
    plan.goals.push_back(sleeps());
    return plan;
}

}  // namespace plumb::families
