#include "editor/model/project/script_definitions.hpp"

#include "core/log.hpp"
#include "editor/model/safety/backups.hpp"
#include "script/script_api.hpp"

namespace plumb::editor {

void writeScriptDefinitions(const Path& project, const GameContent& content) {
    if (content.scripts().empty()) return;
    const Path file = makeEditorFolder(project) / "plumb.d.lua";
    const std::string text = scriptDefinitions(content.types());
    std::error_code failed;
    if (std::filesystem::exists(file, failed)) {
        const Result<std::string> written = readFile(file);
        if (written && *written == text) return;
    }
    if (const Result<Done> written = writeFile(file, text); !written) logWarning("Editor", written.error());
}

}  // namespace plumb::editor
