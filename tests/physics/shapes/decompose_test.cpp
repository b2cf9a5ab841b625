#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "physics/shapes/hull.hpp"
#include "tests/physics/support/random_shapes.hpp"

namespace plumb::physics {
namespace {

using namespace test;

float areaOfLoop(const std::vector<Vec2>& loop) {
    double twice = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 a = loop[i];
        const Vec2 b = loop[(i + 1) % loop.size()];
        twice += static_cast<double>(a.x) * static_cast<double>(b.y) -
                 static_cast<double>(a.y) * static_cast<double>(b.x);
    }
    return static_cast<float>(0.5 * std::fabs(twice));
}

/// True if a point is inside a loop: a ray to the right crosses it an odd number of times.
bool isInside(const std::vector<Vec2>& loop, Vec2 p) {
    bool inside = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 a = loop[i];
        const Vec2 b = loop[(i + 1) % loop.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
            inside = !inside;
    }
    return inside;
}

int piecesAround(const std::vector<Hull>& pieces, Vec2 p, float margin) {
    return static_cast<int>(std::count_if(pieces.begin(), pieces.end(), [&](const Hull& hull) {
        return std::all_of(hull.corners.begin(), hull.corners.end(),
                           [&](const Corner& c) { return dot(c.normal, p - c.point) <= margin; });
    }));
}

/// Creates a star with random arms: a simple polygon, concave in about half of the corners.
std::vector<Vec2> randomStar(Random& random, float size) {
    std::vector<Vec2> loop;
    const std::uint32_t count = 4 + random.below(60);
    for (std::uint32_t i = 0; i < count; ++i) {
        const SinCos at =
            sinCos(kTau * (static_cast<float>(i) + random.between(0.0f, 0.9f)) / static_cast<float>(count));
        loop.push_back(Vec2{at.cos, at.sin} * random.between(0.2f, 1.0f) * size);
    }
    return loop;
}

TEST(DecomposeProperty, thePiecesCoverTheOutlineExactly) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const float size = random.between(0.1f, 100.0f);
        std::vector<Vec2> loop = randomStar(random, size);
        if (random.below(2) == 0) std::reverse(loop.begin(), loop.end());
        const auto pieces = decompose(loop);
        ASSERT_TRUE(pieces.ok()) << pieces.error().text();
        float area = 0.0f;
        for (const Hull& hull : *pieces) area += hull.area;
        EXPECT_NEAR(area, areaOfLoop(loop), 1e-4f * size * size);
        EXPECT_LE(pieces->size(), loop.size() - 2);
        for (int i = 0; i < 100; ++i) {
            const Vec2 point = randomPoint(random, size);
            if (isInside(loop, point)) {
                EXPECT_GE(piecesAround(*pieces, point, 1e-4f * size), 1);
                EXPECT_LE(piecesAround(*pieces, point, -1e-4f * size), 1);
            } else {
                EXPECT_EQ(piecesAround(*pieces, point, -1e-4f * size), 0);
            }
        }
    }
}

TEST(Decompose, aConvexOutlineStaysOnePieceUnlessItHasTooManyCorners) {
    const auto loopOf = [](int count) {
        std::vector<Vec2> loop;
        for (int i = 0; i < count; ++i) {
            const SinCos at = sinCos(kTau * static_cast<float>(i) / static_cast<float>(count));
            loop.push_back({at.cos, at.sin});
        }
        return loop;
    };
    EXPECT_EQ(decompose(loopOf(3))->size(), 1u);
    EXPECT_EQ(decompose(loopOf(32))->size(), 1u);
    EXPECT_EQ(decompose(loopOf(33))->size(), 2u);
    EXPECT_LE(decompose(loopOf(300))->size(), 25u);
}

TEST(Decompose, anLNeedsTwoPiecesAndACrossAtMostFive) {
    const std::vector<Vec2> l{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    const std::vector<Vec2> plus{{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2},
                                 {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
    EXPECT_EQ(decompose(l)->size(), 2u);
    EXPECT_LE(decompose(plus)->size(), 5u);
}

TEST(Decompose, repeatedPointsAndStraightSidesDoNotMatter) {
    const std::vector<Vec2> square{{0, 0}, {0, 0}, {1, 0}, {2, 0}, {2, 1},
                                   {2, 2}, {1, 2}, {0, 2}, {0, 1}, {0, 0}};
    const auto pieces = decompose(square);
    ASSERT_TRUE(pieces.ok()) << pieces.error().text();
    ASSERT_EQ(pieces->size(), 1u);
    EXPECT_EQ(pieces->front().corners.size(), 4u);
}

TEST(Decompose, invalidOutlinesAreRejectedWithTheirReason) {
    const auto refusal = [](std::vector<Vec2> points) {
        const auto pieces = decompose(points);
        return pieces.ok() ? std::string{} : pieces.error().text();
    };
    EXPECT_NE(refusal({{0, 0}, {2, 2}, {2, 0}, {0, 2}}).find("cross or touch"), std::string::npos);
    EXPECT_NE(refusal({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}).find("cross or touch"), std::string::npos);
    EXPECT_NE(refusal({{0, 0}, {1, 0}, {3, 0}, {1, 0}, {0, 1}}).find("turns back"), std::string::npos);
    EXPECT_NE(refusal({{0, 0}, {1, 1}}).find("no area"), std::string::npos);
    EXPECT_NE(refusal({{0, 0}, {1, 0}, {2, 0}, {3, 0}}).find("turns back"), std::string::npos);
    EXPECT_NE(refusal({{0, 0}, {1, 0}, {0, std::numeric_limits<float>::quiet_NaN()}}).find("nan"),
              std::string::npos);
    EXPECT_NE(refusal({{0, 0}, {1, 0}, {1, 1e-7f}}).find("too thin"), std::string::npos);
    EXPECT_NE(refusal(std::vector<Vec2>(kMaxOutline + 1)).find("2049 points"), std::string::npos);
}

TEST(DecomposeProperty, anyPointsGivePiecesOrAnError) {
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        std::vector<Vec2> loop;
        for (std::uint32_t i = 0; i < random.below(12); ++i) {
            loop.push_back({static_cast<float>(random.below(5)), static_cast<float>(random.below(5))});
        }
        const auto pieces = decompose(loop);
        if (!pieces) continue;
        float area = 0.0f;
        for (const Hull& hull : *pieces) area += hull.area;
        EXPECT_NEAR(area, areaOfLoop(loop), 1e-3f);
    }
}

}  // namespace
}  // namespace plumb::physics
