#include "editor/model/input/key_words.hpp"

#include "editor/model/actions.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor {

std::string keysFor(const Workspace& workspace, std::string_view action) {
    const Action* row = findAction(action);
    if (row == nullptr) return std::string{action};
    std::string keys = workspace.settings.keys.shownOf(*row).text();
    return keys.empty() ? std::string{row->label} : keys;
}

std::string withKeys(const Workspace& workspace, std::string_view sentence) {
    std::string text;
    while (true) {
        const std::size_t open = sentence.find('{');
        const std::size_t close = open == sentence.npos ? open : sentence.find('}', open);
        if (close == sentence.npos) return text.append(sentence);
        text += sentence.substr(0, open);
        text += keysFor(workspace, sentence.substr(open + 1, close - open - 1));
        sentence.remove_prefix(close + 1);
    }
}

}  // namespace plumb::editor
