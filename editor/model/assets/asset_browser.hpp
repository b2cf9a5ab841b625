#pragma once

#include <string>
#include <vector>

#include "editor/model/assets/asset_catalog.hpp"
#include "editor/model/assets/asset_uses.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor {

/// State and operations of the asset browser: the open folder, the search, the selected file.
class AssetBrowser {
public:
    explicit AssetBrowser(Workspace& workspace);

    void refresh() { catalog_.refresh(); }
    [[nodiscard]] const AssetCatalog& catalog() const { return catalog_; }
    void enter(std::string_view folder);
    /// Returns the content of the open folder, or the files of the whole project that match the search.
    [[nodiscard]] std::vector<AssetItem> shown() const;
    /// Returns a description: "picture, 32 x 16 px".
    [[nodiscard]] std::string describe(const AssetItem& item);
    [[nodiscard]] std::vector<AssetUse> usesOf(std::string_view path) const;

    /// Rename or delete a file, as one undo step. @return an error message for the user; empty on success
    std::string rename(std::string_view from, std::string_view to);
    std::string remove(std::string_view path);
    /// Moves a file into a folder, keeping its name.
    void moveInto(std::string_view path, std::string_view folder);
    /// Adds the asset to the scene (placeAsset). @param at  px, in world space
    void place(std::string_view path, Vec2 at);

    std::string folder;    ///< open folder; empty: the project's root
    std::string search;    ///< search words; empty: the folder is shown
    std::string selected;  ///< path of the selected item

private:
    Workspace& workspace_;
    AssetCatalog catalog_;
};

}  // namespace plumb::editor
