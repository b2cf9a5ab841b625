#include <cstdio>
#include <vector>

#include "core/crash.hpp"
#include "editor/ui/editor_app.hpp"

/// Entry point of the editor.
int main(int count, char** arguments) {
    plumb::reportCrashes(
        "the editor offers unsaved changes at its next start; to find the line of the code, run it in a "
        "debugger: ./plumb edit PROJECT --debug");
    const std::vector<const char*> words(arguments + 1, arguments + count);
    const auto options = plumb::editor::parseEditorOptions(words);
    if (!options) {
        std::fprintf(stderr, "plumb-editor: %s\n", options.error().text().c_str());
        return 2;
    }
    if (options->help) {
        std::fputs(plumb::editor::editorUsage().c_str(), stdout);
        return 0;
    }
    return plumb::editor::ui::runEditor(*options);
}
