#include "platform/key_codes.hpp"

#include <set>

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(KeyCodes, everyKeyHasExactlyOneUsage) {
    std::set<Key> seen;
    for (int usage = 0; usage < 256; ++usage) {
        const Key key = keyFromUsage(usage);
        if (key != Key::None) {
            EXPECT_TRUE(seen.insert(key).second) << nameOf(key);
        }
    }
    EXPECT_EQ(seen.size(), kKeyCount - 1);
}

TEST(KeyCodes, usagesMatchTheUsbTables) {
    EXPECT_EQ(keyFromUsage(4), Key::A);
    EXPECT_EQ(keyFromUsage(29), Key::Z);
    EXPECT_EQ(keyFromUsage(30), Key::Digit1);
    EXPECT_EQ(keyFromUsage(39), Key::Digit0);
    EXPECT_EQ(keyFromUsage(44), Key::Space);
    EXPECT_EQ(keyFromUsage(56), Key::Slash);
    EXPECT_EQ(keyFromUsage(69), Key::F12);
    EXPECT_EQ(keyFromUsage(78), Key::PageDown);
    EXPECT_EQ(keyFromUsage(82), Key::Up);
    EXPECT_EQ(keyFromUsage(98), Key::Pad0);
    EXPECT_EQ(keyFromUsage(231), Key::RightSuper);
    EXPECT_EQ(keyFromUsage(-1), Key::None);
    EXPECT_EQ(keyFromUsage(1000), Key::None);
}

}  // namespace
}  // namespace plumb
