#include "math/vec2.hpp"

#include <gtest/gtest.h>

#include "math/rot.hpp"

namespace plumb {
namespace {

TEST(Vec2, bracesAreNormalizedAsAVectorAlthoughRotationsAreNormalizedToo) {
    EXPECT_EQ(normalized({3.0f, 4.0f}), (Vec2{3.0f / 5.0f, 4.0f / 5.0f}));
    EXPECT_EQ(normalized({0.0f, 0.0f}), Vec2{});
    const Rot quarter{0.0f, 2.0f};
    EXPECT_EQ(normalized(quarter), (Rot{0.0f, 1.0f}));
}

}  // namespace
}  // namespace plumb
