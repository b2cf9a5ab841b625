#include "core/text_store.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace plumb {
namespace {

/// Texts that differ, of very different lengths.
std::vector<std::string> texts(std::size_t count) {
    Random random = Random::seeded(1);
    std::vector<std::string> made;
    for (std::size_t i = 0; i < count; ++i)
        made.push_back(std::to_string(i) + std::string(random.below(40), 'x'));
    return made;
}

void expectAll(const TextStore& store, const std::vector<std::string>& texts, std::size_t count) {
    ASSERT_EQ(store.size(), count);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const std::string_view expected = i < count ? std::string_view{texts[i]} : std::string_view{};
        ASSERT_EQ(store.find(textId(texts[i])), expected) << i << " of " << count;
        ASSERT_EQ(store.find(textId(texts[i]).value), expected);
    }
}

TEST(TextStores, findEveryTextThatWasAddedAndNoOther) {
    const std::vector<std::string> all = texts(3000);
    TextStore store;
    EXPECT_EQ(store.size(), 0u);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const TextId id = store.add(all[i]);
        ASSERT_EQ(id, textId(all[i]));
        ASSERT_EQ(store.find(id), all[i]);
        if (i % 100 == 0 || (i >= 31 && i <= 33)) expectAll(store, all, i + 1);
    }
    for (const std::string& text : all) store.add(text);
    expectAll(store, all, all.size());
}

TEST(TextStores, theEmptyTextHasTheIdZeroAndIsNotStored) {
    TextStore store;
    EXPECT_TRUE(store.add("").empty());
    EXPECT_EQ(store.size(), 0u);
    EXPECT_EQ(store.find(TextId{}), "");
    EXPECT_FALSE(store.add("a").empty());
}

TEST(TextStores, viewsStayValidWhileTheStoreGrows) {
    TextStore store;
    const std::string_view first = store.find(store.add("first"));
    for (const std::string& text : texts(1000)) store.add(text);
    EXPECT_EQ(store.find(textId("first")).data(), first.data());
    EXPECT_EQ(first, "first");
}

TEST(TextStores, copiesAreIndependent) {
    const std::vector<std::string> all = texts(200);
    TextStore store;
    for (std::size_t i = 0; i < 100; ++i) store.add(all[i]);
    TextStore copy{store};
    const TextStore& itself = store;
    store = itself;
    for (std::size_t i = 100; i < 200; ++i) copy.add(all[i]);
    expectAll(store, all, 100);
    expectAll(copy, all, 200);
    EXPECT_NE(copy.find(textId(all[0])).data(), store.find(textId(all[0])).data());
    store = copy;
    expectAll(store, all, 200);
    TextStore moved{std::move(copy)};
    expectAll(moved, all, 200);
}

}  // namespace
}  // namespace plumb
