#include "editor/model/debug/script_place.hpp"

#include "core/text.hpp"

namespace plumb::editor {

std::optional<ScriptPlace> scriptPlaceIn(std::string_view text) {
    constexpr std::string_view kFolder = "scripts/";
    constexpr std::string_view kEnding = ".lua:";
    for (std::size_t at = text.find(kFolder); at != std::string_view::npos; at = text.find(kFolder, at + 1)) {
        const std::size_t end = text.find(kEnding, at);
        if (end == std::string_view::npos) return std::nullopt;
        const std::string_view file = text.substr(at, end + kEnding.size() - 1 - at);
        if (file.find_first_of(" \n\"") != std::string_view::npos) continue;
        std::string_view digits = text.substr(end + kEnding.size());
        digits = digits.substr(0, digits.find_first_not_of("0123456789"));
        const auto line = parseInt(digits);
        if (line && *line > 0) return ScriptPlace{std::string{file}, static_cast<int>(*line)};
    }
    return std::nullopt;
}

}  // namespace plumb::editor
