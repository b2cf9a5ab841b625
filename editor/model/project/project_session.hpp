#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "app/project.hpp"
#include "assets/asset_store.hpp"
#include "editor/model/project/editor_options.hpp"
#include "editor/model/workspace.hpp"
#include "reflect/type_registry.hpp"
#include "scene/files/prefab.hpp"

namespace plumb::editor {

/// A project that is open in the editor: its types, assets and prefabs, and the workspace on top of them.
class ProjectSession {
public:
    /// @param folder  the project's folder
    /// @error         no such project
    static Result<std::unique_ptr<ProjectSession>> open(const std::string& folder);
    /// Nothing to edit yet, for the welcome screen.
    static std::unique_ptr<ProjectSession> none();

    [[nodiscard]] Workspace& workspace() { return *workspace_; }
    [[nodiscard]] AssetStore& assets() { return assets_; }

    /// Opens the scene of this name, else the start scene, else the first one there is.
    void openFirst(std::string_view scene);

    /// Opens every scene, prefab and asset and tells what is wrong with it. @return the program's exit code
    int validate();
    /// Copies the project into a folder that plays by itself. @return the program's exit code
    int exportTo(const std::string& folder);

private:
    explicit ProjectSession(Project project);

    Project project_;
    TypeRegistry types_;
    AssetStore assets_;
    PrefabLibrary prefabs_;
    std::unique_ptr<Workspace> workspace_;
};

/// Makes a scene or an animation, and all that it needs, of a file of Tiled, LDtk or Aseprite; tells what
/// came of it. @return the program's exit code
int importFile(const EditorOptions& options);

}  // namespace plumb::editor
