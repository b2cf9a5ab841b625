#include "editor/ui/widgets/lua_colors.hpp"

#include <algorithm>
#include <array>

#include "editor/ui/theme_colors.hpp"

namespace plumb::editor::ui {
namespace {

constexpr std::array<std::string_view, 22> kKeywords{
    "and", "break", "do",  "else", "elseif", "end",    "false",  "for",  "function", "goto",  "if",
    "in",  "local", "nil", "not",  "or",     "repeat", "return", "then", "true",     "until", "while"};
constexpr int kComment = 1;
constexpr int kLongText = 2;

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isWord(char c) { return isDigit(c) || c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// The end of the run of word characters from `at` on.
std::size_t wordEnd(std::string_view line, std::size_t at) {
    while (at < line.size() && isWord(line[at])) ++at;
    return at;
}

/// The end of the text in quotes that begins at `at`.
std::size_t quotedEnd(std::string_view line, std::size_t at) {
    for (std::size_t i = at + 1; i < line.size(); ++i) {
        if (line[i] == '\\')
            ++i;
        else if (line[i] == line[at])
            return i + 1;
    }
    return line.size();
}

/// The end of what double brackets close; the end of the line if they do not close in it.
std::size_t longEnd(std::string_view line, std::size_t at, int& inLong) {
    const std::size_t close = line.find("]]", at);
    if (close == std::string_view::npos) return line.size();
    inLong = 0;
    return close + 2;
}

}  // namespace

std::vector<ColoredPart> luaColors(std::string_view line, int& inLong) {
    std::vector<ColoredPart> parts;
    std::size_t at = 0;
    const auto add = [&](std::size_t end, ImU32 color) {
        parts.push_back({line.substr(at, end - at), color});
        at = end;
    };
    if (inLong != 0) {
        const ImU32 color = inLong == kComment ? palette::kTextDim : palette::kGreen;
        add(longEnd(line, 0, inLong), color);
    }
    while (at < line.size()) {
        const std::string_view rest = line.substr(at);
        if (rest.substr(0, 4) == "--[[") {
            inLong = kComment;
            add(longEnd(line, at + 4, inLong), palette::kTextDim);
        } else if (rest.substr(0, 2) == "--") {
            add(line.size(), palette::kTextDim);
        } else if (rest.substr(0, 2) == "[[") {
            inLong = kLongText;
            add(longEnd(line, at + 2, inLong), palette::kGreen);
        } else if (line[at] == '"' || line[at] == '\'') {
            add(quotedEnd(line, at), palette::kGreen);
        } else if (isDigit(line[at])) {
            add(wordEnd(line, at), palette::kOrange);
        } else if (isWord(line[at])) {
            const std::size_t end = wordEnd(line, at);
            const bool isKeyword =
                std::find(kKeywords.begin(), kKeywords.end(), line.substr(at, end - at)) != kKeywords.end();
            add(end, isKeyword ? palette::kViolet : palette::kText);
        } else {
            std::size_t end = at + 1;
            while (end < line.size() && !isWord(line[end]) && line[end] != '"' && line[end] != '\'' &&
                   line[end] != '-' && line[end] != '[')
                ++end;
            add(end, palette::kTextSoft);
        }
    }
    return parts;
}

}  // namespace plumb::editor::ui
