#include "editor/model/document/id_table.hpp"

#include <unordered_map>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace plumb::editor {
namespace {

TEST(IdTableTest, isEmptyAtFirstAndAfterClearing) {
    IdTable<int> table;
    EXPECT_EQ(table.find(1), nullptr);
    EXPECT_FALSE(table.erase(1));
    table.set(1, 5);
    ASSERT_NE(table.find(1), nullptr);
    EXPECT_EQ(*table.find(1), 5);
    table.clear();
    EXPECT_EQ(table.size(), 0u);
    EXPECT_EQ(table.find(1), nullptr);
    table.set(2, 6);
    EXPECT_EQ(*table.find(2), 6);
}

TEST(IdTableTest, noEntityHasTheIdZero) {
    IdTable<int> table;
    EXPECT_EQ(table.find(0), nullptr);
    table.set(7, 1);
    EXPECT_EQ(table.find(0), nullptr);
    EXPECT_FALSE(table.erase(0));
}

// Only few ids, so that slots collide and erasing has to close gaps.
TEST(IdTableTest, agreesWithUnorderedMapAfterRandomInsertionsAndErasures) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random = Random::seeded(seed);
        IdTable<int> table;
        std::unordered_map<std::uint64_t, int> expected;
        for (int i = 0; i < 5000; ++i) {
            const auto id = static_cast<std::uint64_t>(random.below(200) + 1);
            if (random.below(3) == 0) {
                ASSERT_EQ(table.erase(id), expected.erase(id) > 0);
            } else {
                table.set(id, i);
                expected[id] = i;
            }
            ASSERT_EQ(table.size(), expected.size());
            for (std::uint64_t known = 1; i % 50 == 0 && known <= 200; ++known) {
                const int* found = table.find(known);
                ASSERT_EQ(found != nullptr, expected.count(known) > 0) << known;
                if (found != nullptr) {
                    ASSERT_EQ(*found, expected[known]);
                }
            }
        }
        EXPECT_GT(table.size(), 50u);
    }
}

}  // namespace
}  // namespace plumb::editor
