#include "platform/paths.hpp"

#include <string_view>
#include <utility>

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(Paths, aGameHasTheFileNameOfItsNameWithoutWhatSystemsRefuse) {
    const std::pair<const char*, const char*> names[] = {{"Wickwood", "Wickwood"},
                                                         {"Sky Caves 2", "Sky Caves 2"},
                                                         {"a/b\\c:d", "abcd"},
                                                         {"What?", "What"},
                                                         {"The end...", "The end"},
                                                         {"...", "game"},
                                                         {"", "game"},
                                                         {".hidden", "game"},
                                                         {"\u00dcber", "\u00dcber"}};
    for (const auto& [name, file] : names) EXPECT_EQ(fileNameOf(name), file) << name;
}

}  // namespace
}  // namespace plumb
