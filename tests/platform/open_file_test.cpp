#include "platform/open_file.hpp"

#include <gtest/gtest.h>

#if !defined(_WIN32)

namespace plumb {
namespace {

TEST(OpenFileTest, theAddressOfAFileEscapesWhatAnAddressCannotHold) {
    EXPECT_EQ(urlOf("/games/a b/#1.lua"), "file:///games/a%20b/%231.lua");
    EXPECT_EQ(urlOf("/\xc3\xa9.cpp"), "file:///%C3%A9.cpp") << "each byte of UTF-8";
    EXPECT_EQ(urlOf("/x/../y.lua"), "file:///y.lua");
}

}  // namespace
}  // namespace plumb

#endif
