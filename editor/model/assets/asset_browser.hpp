#pragma once

#include <string>
#include <vector>

#include "editor/model/assets/asset_catalog.hpp"
#include "editor/model/assets/asset_uses.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor {

/// Looks through the files of the project: where one is, what one searches, what is selected, and what can be
/// done with it.
class AssetBrowser {
public:
    explicit AssetBrowser(Workspace& workspace);

    void refresh() { catalog_.refresh(); }
    [[nodiscard]] const AssetCatalog& catalog() const { return catalog_; }
    void enter(std::string_view folder);
    /// What lies in the folder, or in the whole project what the search finds.
    [[nodiscard]] std::vector<AssetItem> shown() const;
    /// "picture, 32 x 16 px".
    [[nodiscard]] std::string describe(const AssetItem& item);
    [[nodiscard]] std::vector<AssetUse> usesOf(std::string_view path) const;

    /// Each is one step of undo. @return what went wrong, for the person; empty: nothing
    std::string rename(std::string_view from, std::string_view to);
    std::string remove(std::string_view path);
    /// Moves a file into a folder, under its name.
    void moveInto(std::string_view path, std::string_view folder);
    /// Puts a file into the scene.
    void place(std::string_view path, Vec2 at);

    std::string folder;    ///< that is looked at; empty is the project's own
    std::string search;    ///< words; empty shows the folder
    std::string selected;  ///< path

private:
    Workspace& workspace_;
    AssetCatalog catalog_;
};

}  // namespace plumb::editor
