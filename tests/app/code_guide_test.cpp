#include <gtest/gtest.h>

#include "core/file.hpp"
#include "tests/support/places.hpp"

// The guide shows the code of the template, which is built and tested.

namespace plumb {
namespace {

TEST(CodeGuide, showsTheCodeOfTheTemplate) {
    const std::string guide = *readFile(test::sourceFolder() / "docs/code.md");
    const std::string code = *readFile(test::sourceFolder() / "assets/templates/cpp/code/game.cpp");
    EXPECT_GT(code.size(), 1000u);
    EXPECT_NE(guide.find("```cpp\n" + code + "```"), std::string::npos)
        << "copy assets/templates/cpp/code/game.cpp into docs/code.md";
}

}  // namespace
}  // namespace plumb
