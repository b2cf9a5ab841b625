#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "editor/model/assets/asset_catalog.hpp"
#include "editor/model/document/object_id.hpp"
#include "editor/model/finder/fuzzy.hpp"

namespace plumb::editor {

class Workspace;

/// An entry of the finder: a file, an entity or a command.
struct FinderItem {
    enum class Kind : unsigned char { Scene, Prefab, Entity, Asset, Command };
    Kind kind = Kind::Asset;
    std::string text;      ///< searched text: "assets/tiles.png", "Edit: Undo", "crate"
    std::size_t name = 0;  ///< index in `text` at which the name begins
    std::string id;        ///< path, action id, or hexadecimal entity id
    std::string detail;    ///< shown beside `text`: a command's keys, an entity's parent
    AssetKind asset = AssetKind::None;
    ObjectId object;
    bool possible = true;  ///< false: a command that is disabled now
};

/// A row of the result list.
struct FinderRow {
    std::size_t item = 0;  ///< index for Finder::item
    FuzzyMatch match;
};

/// Fuzzy search for files and entities, commands, scenes to open, or prefabs to add. Recently chosen entries
/// come first.
class Finder {
public:
    enum class What : unsigned char { Files, Commands, Scenes, Prefabs };
    static constexpr std::size_t kMaxRows = 200;   ///< maximum number of rows
    static constexpr std::size_t kMaxRecent = 20;  ///< maximum number of recent entries

    /// Collects the entries from the project and the open scene.
    void open(const Workspace& workspace, What what);
    /// Searches for the typed text. When searching files, a leading ">" searches commands instead, "@" only
    /// entities.
    void search(const Workspace& workspace, std::string typed);

    [[nodiscard]] What what() const { return what_; }
    [[nodiscard]] const std::vector<FinderRow>& rows() const { return rows_; }
    [[nodiscard]] const FinderItem& item(const FinderRow& row) const { return items_[row.item]; }
    /// Total number of matches, which may exceed the number of rows.
    [[nodiscard]] std::size_t found() const { return found_; }

    std::size_t chosen = 0;  ///< index of the highlighted row
    /// Moves the highlighted row by this number, wrapping around.
    void step(int by);

    /// Executes the highlighted row: runs a command, selects and frames an entity, shows a file, adds or
    /// edits a prefab. A scene is only returned, because the window must ask about unsaved changes first.
    /// @return path of the scene to open, or empty
    std::string choose(Workspace& workspace);
    /// Kinds and ids of the recently chosen entries, latest first.
    [[nodiscard]] const std::vector<std::string>& recent() const { return recent_; }

private:
    void collectFiles(const Workspace& workspace);
    void collectScenes(const Workspace& workspace);
    void collectPrefabs(const Workspace& workspace);
    void collectEntities(const Workspace& workspace);
    void collectCommands(const Workspace& workspace);
    void collect(const Workspace& workspace, What what);
    [[nodiscard]] std::size_t recency(const FinderItem& item) const;
    /// Highlights the second row if the first one is the open scene.
    void leaveOpenScene(const Workspace& workspace);

    What what_ = What::Files;
    What collected_ = What::Files;
    std::vector<FinderItem> items_;
    std::vector<std::size_t> recencies_;  // index in recent_, by item; kMaxRecent: not in it
    std::vector<FinderRow> rows_;
    std::size_t found_ = 0;
    std::vector<std::string> recent_;
};

}  // namespace plumb::editor
