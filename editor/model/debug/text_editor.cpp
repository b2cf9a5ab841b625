#include "editor/model/debug/text_editor.hpp"

#include <array>
#include <utility>

#include "core/text.hpp"
#include "editor/model/project/program.hpp"
#include "platform/open_file.hpp"

namespace plumb::editor {
namespace {

std::string replaced(std::string word, std::string_view what, const std::string& by) {
    for (std::size_t at = word.find(what); at != std::string::npos; at = word.find(what, at + by.size()))
        word.replace(at, what.size(), by);
    return word;
}

/// Returns the place whose file ends at `end` and whose line number follows after a colon.
std::optional<ScriptPlace> placeAt(std::string_view text, std::size_t end) {
    std::string_view digits = text.substr(end + 1);
    digits = digits.substr(0, digits.find_first_not_of("0123456789"));
    const auto line = parseInt(digits);
    if (!line || *line <= 0) return std::nullopt;
    const std::size_t before = text.substr(0, end).find_last_of(" \t\n\"'(");
    const std::string_view file = text.substr(before + 1, end - before - 1);  // npos + 1 is the start
    return ScriptPlace{std::string{file}, static_cast<int>(*line)};
}

}  // namespace

std::optional<ScriptPlace> sourcePlaceIn(std::string_view text) {
    if (auto script = scriptPlaceIn(text)) return script;
    constexpr std::array<std::string_view, 4> kEndings{".cpp:", ".hpp:", ".h:", ".inl:"};
    for (std::size_t at = text.find('.'); at != std::string_view::npos; at = text.find('.', at + 1)) {
        for (const std::string_view ending : kEndings) {
            if (!startsWith(text.substr(at), ending)) continue;
            if (auto place = placeAt(text, at + ending.size() - 1)) return place;
        }
    }
    return std::nullopt;
}

std::vector<std::string> wordsOf(std::string_view command, const Path& file, int line) {
    std::vector<std::string> words;
    bool inQuotes = false;
    bool inWord = false;
    for (const char letter : command) {
        if (letter == '"') {
            inQuotes = !inQuotes;
        } else if (letter == ' ' && !inQuotes) {
            inWord = false;
            continue;
        }
        if (!std::exchange(inWord, true)) words.emplace_back();
        if (letter != '"') words.back() += letter;
    }
    const bool namesFile = command.find("{file}") != std::string_view::npos;
    for (std::string& word : words)
        word = replaced(replaced(word, "{line}", std::to_string(line)), "{file}", file.string());
    if (!words.empty() && !namesFile) words.push_back(file.string());
    return words;
}

Result<Done> openInTextEditor(std::string_view command, const Path& root, const ScriptPlace& place) {
    std::error_code failed;
    const Path file = std::filesystem::absolute(root / place.file, failed).lexically_normal();
    if (!std::filesystem::is_regular_file(file, failed))
        return Error{file.generic_string(), "there is no such file", "it may have been moved or deleted"};
    const std::vector<std::string> words = wordsOf(command, file, place.line);
    if (words.empty()) return openFile(file);
    if (const Result<Done> started = startProgram(words); !started)
        return Error{started.error().where, started.error().what,
                     "set another command in Preferences > Editing > Text editor"};
    return Done{};
}

}  // namespace plumb::editor
