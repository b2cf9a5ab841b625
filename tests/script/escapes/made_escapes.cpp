#include "tests/script/escapes/escape.hpp"

// Texts that could confuse the preparation of scripts: if it takes code for a text or a comment, a loop in it
// has no budget, and the script never ends.

namespace plumb::test {
namespace {

constexpr const char* kTooLong = "takes too long";
const std::string kLoop = "while true do end ";

std::string times(int count, const std::string& text) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

std::string numbered(int count, const std::string& before, const std::string& after) {
    std::string all;
    for (int i = 1; i <= count; ++i) all += before + std::to_string(i) + after;
    return all;
}

std::vector<Escape> endsOfLines() {
    return {
        {"crEndsAComment", "-- comment\r" + kLoop + "\nreturn 1", true, kTooLong},
        {"crEndsAShebang", "#!/usr/bin/lua\r" + kLoop + "\nreturn 1", true, kTooLong},
        {"crLfFile", "local s = 0\r\nfor i = 1, 3 do\r\n s = s + i -- add\r\nend\r\nreturn s", false, "6"},
        {"lfCrFile", "local s = 0\n\rfor i = 1, 3 do\n\r s = s + i -- add\n\rend\n\rreturn s", false, "6"},
        {"crFile", "local s = 0\rfor i = 1, 3 do\r s = s + i -- add\rend\rreturn s", false, "6"},
        {"crLfAfterBackslash", "local a = 'x\\\r\n' " + kLoop + "local b = '' return 1", true, kTooLong},
        {"lfCrAfterBackslash", "local a = 'x\\\n\r' " + kLoop + "local b = '' return 1", true, kTooLong},
        {"crAfterBackslash", "local a = 'x\\\r' " + kLoop + "local b = '' return 1", true, kTooLong},
        {"lfAfterBackslash", "local a = 'x\\\n' " + kLoop + "local b = '' return 1", true, kTooLong},
        {"skippedSpaceWithLines", "local a = 'x\\z \n\r\n\t ' " + kLoop + "local b = '' return 1", true,
         kTooLong},
        {"skippedSpaceThenQuote", "local a = 'x\\z\n\\'' " + kLoop + "local b = '' return 1", true, kTooLong},
        {"crInsideOfQuotes", "local a = 'x\r' " + kLoop, true, "unfinished string"},
        {"crInALongText", "local a = [[\r]] " + kLoop, true, kTooLong},
        {"verticalTabAndFormFeed", "while\vtrue\fdo\vend", true, kTooLong},
    };
}

std::vector<Escape> bytes() {
    using namespace std::string_literals;
    return {
        {"byteOrderMark", "\xef\xbb\xbfreturn 7", false, "7"},
        {"byteOrderMarkAndShebang", "\xef\xbb\xbf#!/usr/bin/lua\nreturn 7", false, "7"},
        {"nulInACommentHidesNothing", "-- \0\n"s + kLoop, true, kTooLong},
        {"nulInATextHidesNothing", "local a = '\0' "s + kLoop, true, kTooLong},
        {"nulInALongTextHidesNothing", "local a = [[\0]] "s + kLoop, true, kTooLong},
        {"nulInCode", "return \0 1"s, true, "unexpected symbol"},
        {"nulInAFormat", "return (string.format('\0%p', {}))"s, true, "on each machine"},
        {"notUtf8", "return '\xff'", true, "not UTF-8"},
        {"byteCode", "\x1bLua\x54", true, "a.lua:1:"},
        {"unicodeName", "local \xc3\xa4 = 1", true, "a.lua:1:"},
        {"unicodeEscapes", "return utf8.len('\\u{7FFFFFFF}\\u{0}', 1, -1, true)", false, "2"},
        {"unicodeEscapeTooLarge", "return '\\u{80000000}'", true, "UTF-8 value too large"},
        {"nextLineCharacterIsNoSpace", "while true\xc2\x85 do end", true, "a.lua:1:"},
    };
}

std::vector<Escape> sizes() {
    return {
        {"longLine", "local s = 0 " + times(50'000, "s = s + 1 ") + "return s", false, "50000"},
        {"longText", "return #'" + std::string(3'000'000, 'x') + "'", false, "3000000"},
        {"longComment",
         "--[" + std::string(2000, '=') + "[ ]] " + kLoop + "]" + std::string(2000, '=') + "] return 2",
         false, "2"},
        {"longName", "local " + std::string(100'000, 'a') + " = 3 return " + std::string(100'000, 'a'), false,
         "3"},
        {"manyLocals", numbered(300, "local a", " = 1 ") + "return 1", true, "too many local variables"},
        {"manyUpvalues",
         "local function outer() " + numbered(150, "local a", " = 1 ") + " return function() " +
             numbered(140, "local b", " = 2 ") + " return function() return 0" + numbered(150, " + a", "") +
             numbered(140, " + b", "") + " end end end return 1",
         true, "too many upvalues"},
        {"manyParentheses", "return " + times(10'000, "(") + "1" + times(10'000, ")"), true, "overflow"},
        {"manyBraces", "return " + times(10'000, "{") + times(10'000, "}"), true, "overflow"},
        {"manyFunctions", times(190, "return (function() ") + "return 5 " + times(190, "end)() "), true,
         "overflow"},
        {"someFunctions", times(50, "return (function() ") + "return 5 " + times(50, "end)() "), false, "5"},
        {"manyBlocks", times(10'000, "do ") + times(10'000, "end "), true, "overflow"},
        {"manyElseIfs", "local x = 5 if x == 0 then " + times(2000, "elseif x == 1 then ") + "end return x",
         false, "5"},
        {"manyUnaries", "return " + times(10'000, "not ") + "1", true, "overflow"},
        {"manyConcatenations", "return 'x'" + times(10'000, " .. 'x'"), true, "overflow"},
        {"manyAssignments", "local a " + times(10'000, "a, ") + "a = 1", true, "overflow"},
        {"manyConstants", "local t = {" + numbered(70'000, "'k", "', ") + "} return #t", false, "70000"},
        {"manyLabels", numbered(100, "::l", ":: ") + "goto l1", true, kTooLong},
        {"manyGotos", "do " + times(20'000, "goto done ") + "end ::done:: return 4", false, "4"},
        {"openBracketsWithLevels", "return " + times(2000, "[" + std::string(200, '=')), true, "a.lua:"},
    };
}

}  // namespace

std::vector<Escape> madeEscapes() {
    std::vector<Escape> all;
    for (const auto& part : {endsOfLines(), bytes(), sizes()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace plumb::test
