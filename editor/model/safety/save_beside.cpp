#include "editor/model/safety/save_beside.hpp"

#include "core/text.hpp"
#include "editor/model/document/prefab_file.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor {

Result<Path> saveBeside(const Workspace& workspace) {
    const std::string& scene = workspace.document.scenePath;
    const std::string kind = isPrefabFile(scene) ? ".prefab" : ".scene";
    const std::string stem = scene.substr(0, scene.find(kind + "."));
    Path file;
    for (int i = 1; file.empty() || std::filesystem::exists(file); ++i) {
        file = workspace.project.root /
               format("{}.mine{}{}.json", stem, i == 1 ? std::string{} : std::to_string(i), kind);
    }
    const Result<Done> written = writeFile(file, workspace.text());
    if (!written) return written.error();
    return file;
}

}  // namespace plumb::editor
