#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "reflect/type_info.hpp"

namespace plumb::editor {

/// A file or a folder of a project, as the asset browser shows it.
struct AssetItem {
    std::string path;                  ///< path in the project, separated by '/'
    AssetKind kind = AssetKind::None;  ///< None: a folder, or a file of a type that games do not load
    bool folder = false;

    [[nodiscard]] std::string_view name() const;   ///< file name: the path after the last '/'
    [[nodiscard]] std::string_view title() const;  ///< file name without ".scene.json", ".prefab.json" …
};

/// Returns the kind of a file by its extension.
AssetKind assetKindOf(std::string_view path);
/// Returns the name of a kind: "picture", "tileset", …; "file" for None.
std::string_view nameOfKind(AssetKind kind);

/// List of a project's files and folders, without hidden and temporary (.tmp) ones.
class AssetCatalog {
public:
    explicit AssetCatalog(Path root) : root_{std::move(root)} {}

    /// Reads the folders again; takes about 3 us per file.
    void refresh();
    /// Increases when a file or folder is added, removed or renamed.
    [[nodiscard]] std::uint32_t revision() const { return revision_; }

    /// All files and folders, sorted by path.
    [[nodiscard]] const std::vector<AssetItem>& all() const { return items_; }
    /// Returns the direct content of a folder, subfolders first. @param folder  empty: the project's root
    [[nodiscard]] std::vector<AssetItem> in(std::string_view folder) const;
    /// Returns the files whose path contains all words of `text`, ignoring case.
    [[nodiscard]] std::vector<AssetItem> search(std::string_view text) const;
    [[nodiscard]] const Path& root() const { return root_; }

private:
    Path root_;
    std::vector<AssetItem> items_;
    std::uint32_t revision_ = 0;
};

}  // namespace plumb::editor
