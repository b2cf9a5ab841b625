#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"

namespace plumb {

/// Help on one option of a command line.
struct OptionHelp {
    std::string_view name;   ///< "--size"
    std::string_view value;  ///< placeholder of its value, "WxH"; empty for a switch
    std::string_view doc;    ///< purpose and allowed values
};

/// A row of a program's option table. All programs parse and list their options in the same way.
template <class Options>
struct OptionRow {
    std::string_view name;
    std::string_view value;
    std::string_view doc;
    bool (*set)(Options& options, std::string_view value);  ///< returns false if the value is invalid

    [[nodiscard]] OptionHelp help() const { return {name, value, doc}; }
};

/// Returns the list of options, one per line, with their descriptions in a second column.
std::string optionLines(std::span<const OptionHelp> options);

Error unknownOption(std::string_view name, std::span<const OptionHelp> options);
/// @param value  the given value; null if it is missing
Error wrongValue(const OptionHelp& option, const std::string_view* value);

/// Functions for `set`. Return false for an empty text.
bool setText(std::string_view text, std::string& field);
/// Returns false, too, if the path does not end with ".png", in letters of either case.
bool setPngPath(std::string_view text, std::string& field);

template <class Options>
std::vector<OptionHelp> helpOf(std::span<const OptionRow<Options>> rows) {
    std::vector<OptionHelp> help;
    for (const OptionRow<Options>& row : rows) help.push_back(row.help());
    return help;
}

/// Reads `--name`, `--name value` and `--name=value`.
/// @param onWord  called with each word that does not belong to an option; may return an error
/// @error an unknown option (the remedy names the closest one), a missing or wrong value
template <class Options, class OnWord>
Result<Done> readOptions(std::span<const OptionRow<Options>> rows, std::span<const char* const> words,
                         Options& options, OnWord onWord) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string_view word = words[i];
        if (word.substr(0, 1) != "-") {
            if (Result<Done> taken = onWord(word); !taken) return taken;
            continue;
        }
        const std::size_t equals = word.find('=');
        const std::string_view name = word.substr(0, equals);
        const OptionRow<Options>* found = nullptr;
        for (const OptionRow<Options>& row : rows) {
            if (row.name == name) found = &row;
        }
        if (found == nullptr) return unknownOption(name, helpOf(rows));
        std::string_view value;
        if (equals != std::string_view::npos) {
            value = word.substr(equals + 1);
        } else if (!found->value.empty()) {
            if (++i == words.size()) return wrongValue(found->help(), nullptr);
            value = words[i];
        }
        if (!found->set(options, value)) return wrongValue(found->help(), &value);
    }
    return Done{};
}

}  // namespace plumb
