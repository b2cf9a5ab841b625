#include "core/fixed_list.hpp"

#include <array>
#include <cstdlib>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/faults.hpp"

namespace plumb {
namespace {

using List = FixedList<int, 4>;
static_assert(std::is_trivially_copyable_v<List>);

/// A list between memory that must not change.
struct Guarded {
    std::array<int, 8> before{};
    List list;
    std::array<int, 8> after{};

    Guarded() { before.fill(7), after.fill(7); }
    [[nodiscard]] bool areGuardsIntact() const {
        std::array<int, 8> untouched{};
        untouched.fill(7);
        return before == untouched && after == untouched;
    }
};

TEST(FixedListProperty, anyCallsDoWhatTheyDoWithAVectorAndWriteNothingElse) {
    const test::Faults faults;
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        Guarded guarded;
        List& list = guarded.list;
        std::vector<int> model;
        for (int step = 0; step < 200; ++step) {
            const int value = static_cast<int>(random.below(1000)) + 1;
            const std::size_t at = random.below(10);
            switch (random.below(4)) {
                case 0:
                case 1:
                    ASSERT_EQ(list.push(value), model.size() < List::capacity());
                    if (model.size() < List::capacity()) model.push_back(value);
                    break;
                case 2:
                    ASSERT_EQ(list.erase(at), at < model.size());
                    if (at < model.size()) model.erase(model.begin() + static_cast<std::ptrdiff_t>(at));
                    break;
                default:
                    list[at] = value;
                    if (at < model.size()) model[at] = value;
            }
            ASSERT_EQ(std::vector<int>(list.begin(), list.end()), model);
            ASSERT_EQ(list.full(), model.size() == List::capacity());
            for (std::size_t i = 0; i < 10; ++i)
                ASSERT_EQ(std::as_const(list)[i], i < model.size() ? model[i] : 0);
            for (std::size_t i = model.size(); i < List::capacity(); ++i) ASSERT_EQ(list.items[i], 0);
            ASSERT_TRUE(guarded.areGuardsIntact());
        }
    }
}

TEST(FixedList, aWrongCountReachesNoMemoryBeyondTheList) {
    const test::Faults faults;
    Guarded guarded;
    guarded.list.count = 1000;
    for (int& item : guarded.list) item = 3;
    guarded.list[4] = 3;
    EXPECT_FALSE(guarded.list.push(3));
    EXPECT_EQ(guarded.list.size(), 4u);
    EXPECT_TRUE(guarded.list.erase(0));
    EXPECT_EQ(guarded.list.count, 3u);
    EXPECT_TRUE(guarded.areGuardsIntact());
}

/// Makes each mistake three times, and exits with the number of lines in the log.
[[noreturn]] void makeMistakes() {
    const test::Faults faults;
    List list;
    for (int i = 0; i < 7; ++i) list.push(i);
    for (std::size_t i = 4; i < 7; ++i) list[i] = 1;
    const bool areClear = faults.mention("push() on a full list of capacity 4") &&
                          faults.mention("check full() first") &&
                          faults.mention("item 4 was requested from a list of size 4 and capacity 4");
    std::exit(areClear ? static_cast<int>(faults.lines().size()) : 100);
}

TEST(FixedList, eachKindOfMistakeIsReportedOnce) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";  // a program in which nothing was reported yet
    EXPECT_EXIT(makeMistakes(), testing::ExitedWithCode(2), "");
}

/// Exits with 0 if each mistake is reported as what it is.
[[noreturn]] void makeEachMistake() {
    test::Faults faults;
    List list;
    list.push(1), list.push(2);
    list[3] = 1;
    const bool isIndexClear = faults.lines().size() == 1 &&
                              faults.mention("item 3 was requested from a list of size 2 and capacity 4") &&
                              faults.mention("compare the index with size()");
    faults.clear();
    for (int i = 0; i < 3; ++i) list.push(i);
    const bool isPushClear = faults.lines().size() == 1 &&
                             faults.mention("push() on a full list of capacity 4") &&
                             faults.mention("check full() first");
    std::exit((isIndexClear ? 0 : 1) + (isPushClear ? 0 : 2));
}

TEST(FixedList, eachKindOfMistakeIsReportedAsWhatItIs) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(makeEachMistake(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace plumb
