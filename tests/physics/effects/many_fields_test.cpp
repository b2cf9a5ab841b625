#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "physics/effects/field_types.hpp"
#include "physics/model/fields.hpp"
#include "physics/workspace.hpp"
#include "tests/physics/support/effect_worlds.hpp"

namespace plumb::physics {
namespace {

using namespace test;

/// Scatters fields of every kind and size over as many bodies, some of which lie exactly on region
/// boundaries.
World scatteredFields(std::uint64_t seed, int fields) {
    Random random = Random::seeded(seed);
    World world = makeSpace();
    const double side = 2.0 * std::sqrt(static_cast<double>(fields));
    const WorldPosition corner{seed % 3 == 0 ? 1.0e6 : -0.5 * side, seed % 3 == 1 ? -3.0e4 : 0.0};
    const auto anywhere = [&] {
        const auto grid = [&] {
            return std::floor(random.between(0.0f, static_cast<float>(2.0 * side))) / 2.0;
        };
        return WorldPosition{corner.x + grid(), corner.y + grid()};
    };
    std::vector<BodyId> bodies;
    for (int i = 0; i < fields; ++i) {
        const std::uint32_t layers = 1u << random.below(2);
        bodies.push_back(addBody(world, BodyKind::Dynamic, anywhere(), circle(random.between(0.1f, 1.0f)),
                                 {.layers = layers, .mask = 0}));
    }
    const auto randomBody = [&] { return bodies[random.below(static_cast<std::uint32_t>(bodies.size()))]; };
    for (int i = 0; i < fields; ++i) {
        FieldDefinition field = fieldOf(static_cast<FieldKind>(random.below(6)));
        field.region = static_cast<RegionKind>(random.below(20) == 0 ? 0 : 1 + random.below(2));
        field.place = anywhere();
        field.half = {0.5f * static_cast<float>(random.below(6)), 0.5f * static_cast<float>(random.below(6))};
        field.radius = 0.5f * static_cast<float>(random.below(6));
        field.layers = random.below(4) == 0 ? 2u : 0xffffffffu;
        field.acceleration = {random.between(-1.0f, 1.0f), 1.0f};
        field.strength = random.between(0.1f, 1.0f);
        field.length = 1.0f;
        if (field.kind == FieldKind::Spring || random.below(2) == 0) field.a = randomBody();
        EXPECT_TRUE(createField(world, field).ok());
    }
    return world;
}

TEST(Fields, actOnExactlyTheBodiesInTheirRegions) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE(seed);
        World world = scatteredFields(seed, seed % 4 == 0 ? 7 : 200);
        for (int i = 0; i < 20; ++i) {
            step(world, kStep);  // the first step removes the explosions
            const World before = world;
            step(world, kStep);
            const Workspace& work = *world.work.lastStep();
            for (std::size_t slot = 0; slot < work.bodyOf.size(); ++slot) {
                const std::uint32_t body = work.bodyOf[slot];
                if (body == kNone) continue;
                std::vector<std::uint32_t> expected;
                for (std::uint32_t f = 0; f < before.fields.all.size(); ++f) {
                    const Field& field = before.fields.all[f];
                    if (field.isAlive && actsOn(before, field.definition, body)) expected.push_back(f);
                }
                const auto found = work.smooth.fieldsOf(slot);
                ASSERT_EQ(std::vector<std::uint32_t>(found.begin(), found.end()), expected) << body;
            }
        }
    }
}

TEST(Fields, haveTheSameBitsWithSpatialSearchFromNineFieldsOn) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE(seed);
        World few = scatteredFields(seed, 8), many = few;
        for (int i = 0; i < 40; ++i) {
            FieldDefinition far = fieldOf(static_cast<FieldKind>(i % 4));
            far.region = RegionKind::Box;
            far.place = {1.0e4 * i, 5.0e5};
            ASSERT_TRUE(createField(many, far).ok());
        }
        for (int i = 0; i < 30; ++i) {
            if (i == 10) {
                for (World* world : {&few, &many}) {
                    FieldDefinition bang = fieldOf(FieldKind::Explosion);
                    bang.strength = 3.0f;
                    bang.radius = 4.0f;
                    for (const std::uint32_t body : {1u, 3u, 2u}) {
                        bang.place = world->bodies.pose[body].centre + Vec2{0.3f, 0.2f};
                        ASSERT_TRUE(createField(*world, bang).ok());
                    }
                }
            }
            step(few, kStep);
            step(many, kStep);
            ASSERT_TRUE(sameState(few, many)) << i;
        }
    }
}

}  // namespace
}  // namespace plumb::physics
