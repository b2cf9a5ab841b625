#include "core/option_rows.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace plumb {
namespace {

constexpr std::size_t kColumn = 26;  // characters before the description
constexpr std::size_t kWidth = 80;   // characters in a line

constexpr const char* kWhere = "command line";

/// Length of the part of a text for one line: up to a blank or after a comma, and at least one word.
std::size_t lineLength(std::string_view text, std::size_t room) {
    if (text.size() <= room) return text.size();
    std::size_t end = text.find_last_of(" ,", room);
    if (end == room && text[end] == ',') end = text.find_last_of(" ,", room - 1);  // no room for the comma
    if (end == std::string_view::npos || end == 0) end = text.find_first_of(" ,");
    if (end == std::string_view::npos) return text.size();
    return text[end] == ',' ? end + 1 : end;
}

}  // namespace

std::string optionLines(std::span<const OptionHelp> options) {
    std::string text;
    for (const OptionHelp& option : options) {
        std::string line = format("  {} {}", option.name, option.value);
        for (std::string_view rest = option.doc; !rest.empty();) {
            line.resize(kColumn, ' ');
            const std::size_t length = lineLength(rest, kWidth - kColumn);
            text += line.append(rest.substr(0, length)) + "\n";
            rest = trimmed(rest.substr(length));
            line.clear();
        }
    }
    return text;
}

Error unknownOption(std::string_view name, std::span<const OptionHelp> options) {
    std::vector<std::string_view> names;
    for (const OptionHelp& option : options) names.push_back(option.name);
    const std::string_view near = closestName(name, names);
    return {kWhere, format("unknown option \"{}\"", name),
            near.empty() ? std::string{"--help lists the options"} : format("did you mean {}?", near)};
}

Error wrongValue(const OptionHelp& option, const std::string_view* value) {
    const std::string usage =
        option.value.empty() ? std::string{option.name} : format("{} {}", option.name, option.value);
    return {kWhere,
            value == nullptr ? format("{} needs a value", option.name)
                             : format("invalid value \"{}\" for {}", *value, option.name),
            format("write {}: {}", usage, option.doc)};
}

bool setText(std::string_view text, std::string& field) {
    field = text;
    return !text.empty();
}

bool setPngPath(std::string_view text, std::string& field) {
    constexpr std::string_view kEnding = ".png";
    const auto inLowerCase = [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    };
    field = text;
    return text.size() >= kEnding.size() &&
           std::equal(kEnding.begin(), kEnding.end(), text.end() - kEnding.size(),
                      [&](char wanted, char c) { return wanted == inLowerCase(c); });
}

}  // namespace plumb
