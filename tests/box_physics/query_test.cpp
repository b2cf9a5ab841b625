#include "tests/box_physics/scene_of_bodies.hpp"

namespace plumb::box_physics {
namespace {

TEST(Query, aRayFindsTheNearestBody) {
    Stage60 s;
    s.box(BodyKind::Static, {5, 0}, {0.5f, 2});
    const BodyId near = s.box(BodyKind::Dynamic, {3, 0}, {0.5f, 0.5f});
    const auto hit = rayCast(s.world, {0, 0}, {10, 0}, s.settings);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->body, near);
    EXPECT_NEAR(hit->point.x, 2.5f, 1e-3f);
    EXPECT_NEAR(hit->touch.time, 0.25f, 1e-3f);
    EXPECT_EQ(hit->touch.normal, (Vec2{-1, 0}));
    EXPECT_FALSE(rayCast(s.world, {0, 0}, {0, 10}, s.settings).has_value());
}

TEST(Query, aFilterHidesWhatIsNotAskedFor) {
    Stage60 s;
    BodyDefinition d;
    d.kind = BodyKind::Static;
    d.position = {2, 0};
    d.isTrigger = true;
    const BodyId trigger = s.add(d);
    Filter filter;
    EXPECT_FALSE(rayCast(s.world, {0, 0}, {5, 0}, s.settings, filter).has_value());
    filter.triggers = true;
    EXPECT_TRUE(rayCast(s.world, {0, 0}, {5, 0}, s.settings, filter).has_value());
    filter.except = trigger;
    EXPECT_FALSE(rayCast(s.world, {0, 0}, {5, 0}, s.settings, filter).has_value());
}

TEST(Query, aShapeCastStopsWhereTheShapeTouches) {
    Stage60 s;
    s.box(BodyKind::Static, {5, 0}, {0.5f, 2});
    const auto hit = shapeCast(s.world, {ShapeKind::Box, {0, 0}, {0.5f, 0.5f}, {10, 0}}, s.settings);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->touch.time, 0.4f, 1e-3f);
}

TEST(Query, overlapListsAllThatShareArea) {
    Stage60 s;
    const BodyId a = s.box(BodyKind::Static, {0, 0}, {1, 1});
    const BodyId b = s.ball({1, 0}, 0.5f);
    s.ball({9, 0}, 0.5f);
    std::vector<BodyId> found;
    overlap(s.world, {ShapeKind::Circle, {0.5f, 0}, {0.3f, 0.3f}, {}}, s.settings, {}, found);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0], a);
    EXPECT_EQ(found[1], b);
}

}  // namespace
}  // namespace plumb::box_physics
