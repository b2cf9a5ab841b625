#include "core/reports.hpp"

#include <random>
#include <set>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(ReportsProperty, eachCombinationIsTheFirstOnceUntilAllAreForgotten) {
    std::mt19937 random{5};
    Reports reports;
    for (int round = 0; round < 3; ++round) {
        std::set<std::tuple<std::string, std::string, std::uint64_t>> known;
        for (int i = 0; i < 2000; ++i) {
            const std::string where(random() % 4, 'a');
            const std::string what(random() % 4, 'a');  // "a" and "aa" are not "aa" and "a"
            const std::uint64_t which = random() % 20;
            ASSERT_EQ(reports.isFirst(where, what, which), known.emplace(where, what, which).second);
            ASSERT_EQ(reports.count(), known.size());
        }
        reports.forget();
        EXPECT_EQ(reports.count(), 0u);
    }
}

TEST(ReportsTest, theCurrentOnesAreThoseOfTheInnermostReporting) {
    Reports outer, inner;
    EXPECT_EQ(Reports::current, nullptr);
    {
        const Reporting first{outer};
        {
            const Reporting second{inner};
            EXPECT_EQ(Reports::current, &inner);
        }
        EXPECT_EQ(Reports::current, &outer);
    }
    EXPECT_EQ(Reports::current, nullptr);
}

}  // namespace
}  // namespace plumb
