#include "editor/model/debug/line_match.hpp"

#include <algorithm>

#include "tests/editor/support/editor_fixture.hpp"

namespace plumb::editor {
namespace {

using Lines = std::vector<std::string>;
using Numbers = std::vector<int>;

const Lines kText{"a", "b", "end", "c", "d", "end"};

TEST(LinesAfterEdit, moveWithLinesThatAreAddedAndRemovedAbove) {
    EXPECT_EQ(linesAfterEdit(kText, kText), (Numbers{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(linesAfterEdit(kText, {"x", "y", "a", "b", "end", "c", "d", "end"}),
              (Numbers{3, 4, 5, 6, 7, 8}));
    EXPECT_EQ(linesAfterEdit(kText, {"a", "b", "end", "x", "end", "c", "d", "end"}),
              (Numbers{1, 2, 3, 6, 7, 8}))
        << "equal lines are matched in order";
    EXPECT_EQ(linesAfterEdit(kText, {"end", "c", "d", "end"}), (Numbers{1, 1, 1, 2, 3, 4}))
        << "what was deleted goes to the line that follows";
}

TEST(LinesAfterEdit, aRewrittenLineKeepsItsPlaceBetweenItsNeighbors) {
    EXPECT_EQ(linesAfterEdit(kText, {"a", "B", "end", "c", "d", "end"}), (Numbers{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(linesAfterEdit(kText, {"x", "a", "B", "end", "c", "D", "end"}), (Numbers{2, 3, 4, 5, 6, 7}));
}

TEST(LinesAfterEdit, everyNumberIsALineOfTheNewText) {
    for (const Lines& after : {Lines{}, Lines{"x"}, Lines{"d", "c"}, Lines{"end"}}) {
        const Numbers numbers = linesAfterEdit(kText, after);
        ASSERT_EQ(numbers.size(), kText.size());
        for (const int number : numbers) {
            EXPECT_GE(number, 1);
            EXPECT_LE(number, std::max(static_cast<int>(after.size()), 1));
        }
        EXPECT_TRUE(std::is_sorted(numbers.begin(), numbers.end()));
    }
    EXPECT_TRUE(linesAfterEdit({}, kText).empty());
}

TEST_F(EditorFixture, breakpointsMoveWithTheirLinesWhenAScriptIsEdited) {
    constexpr const char* kFile = "scripts/slime.lua";
    putFile(kFile, "local a = 1\nlocal b = 2\nlocal c = 3\n");
    putFile("scripts/other.lua", "local a = 1\nlocal b = 2\n");
    workspace.scripts.update(1.0);
    Breakpoints& breakpoints = workspace.debugger.breakpoints;
    breakpoints.set({kFile, 2, "b > 1", true});
    breakpoints.set({kFile, 3, {}, false});
    breakpoints.toggle("scripts/other.lua", 2);

    putFile(kFile, "-- one\n-- two\nlocal a = 1\nlocal b = 2\n-- three\nlocal c = 3\n");
    workspace.scripts.update(1.0);
    const std::vector<Breakpoint> moved{
        {"scripts/other.lua", 2, {}, true}, {kFile, 4, "b > 1", true}, {kFile, 6, {}, false}};
    EXPECT_EQ(breakpoints.all(), moved);
    EXPECT_NE(fileText(".plumb/breakpoints.json").find("\"line\": 6"), std::string::npos)
        << "they are stored there";

    putFile(kFile, "local a = 1\nlocal c = 3\n");
    workspace.scripts.update(1.0);
    ASSERT_EQ(breakpoints.all().size(), 2u);
    EXPECT_NE(breakpoints.find(kFile, 2), nullptr) << "of a deleted line, on the one that follows";
}

}  // namespace
}  // namespace plumb::editor
