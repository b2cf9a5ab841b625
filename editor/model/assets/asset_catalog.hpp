#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "reflect/type_info.hpp"

namespace plumb::editor {

/// A file or a folder of a project, as the asset browser shows it.
struct AssetItem {
    std::string path;                  ///< in the project, with '/'
    AssetKind kind = AssetKind::None;  ///< None: a folder, or a file that games do not load
    bool folder = false;

    [[nodiscard]] std::string_view name() const;   ///< behind the last '/'
    [[nodiscard]] std::string_view title() const;  ///< without the ending, where its picture tells the kind
};

/// What a file is, by its ending.
AssetKind assetKindOf(std::string_view path);
/// "picture", "tileset", …; "file" for None.
std::string_view nameOfKind(AssetKind kind);

/// The files of a project. Hidden ones and what builds leave behind are not among them.
class AssetCatalog {
public:
    explicit AssetCatalog(Path root) : root_{std::move(root)} {}

    /// Reads the folders again. About 3 us a file.
    void refresh();
    /// Grows when something came, went or was renamed.
    [[nodiscard]] std::uint32_t revision() const { return revision_; }

    /// Everything, folders before what is in them, sorted without regard to case.
    [[nodiscard]] const std::vector<AssetItem>& all() const { return items_; }
    /// What lies directly in a folder, folders first. @param folder  empty: the project's own
    [[nodiscard]] std::vector<AssetItem> in(std::string_view folder) const;
    /// Files whose path has all words of `text` in it, in any case.
    [[nodiscard]] std::vector<AssetItem> search(std::string_view text) const;
    [[nodiscard]] const Path& root() const { return root_; }

private:
    Path root_;
    std::vector<AssetItem> items_;
    std::uint32_t revision_ = 0;
};

}  // namespace plumb::editor
