#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "editor/model/assets/asset_catalog.hpp"
#include "editor/model/document/object_id.hpp"
#include "editor/model/finder/fuzzy.hpp"

namespace plumb::editor {

class Workspace;

/// Something that can be gone to or done.
struct FinderItem {
    enum class Kind : unsigned char { Scene, Prefab, Entity, Asset, Command };
    Kind kind = Kind::Asset;
    std::string text;      ///< what is searched: "assets/tiles.png", "Edit: Undo", "crate"
    std::size_t name = 0;  ///< where in it the name begins
    std::string id;        ///< path or action; of an entity its id in hex
    std::string detail;    ///< beside it: keys of a command, the parent of an entity
    AssetKind asset = AssetKind::None;
    ObjectId object;
    bool possible = true;  ///< commands: now
};

/// One line of what was found.
struct FinderRow {
    std::size_t item = 0;  ///< of Finder::items
    FuzzyMatch match;
};

/// What there is, by a few letters of its name: files and entities, commands, scenes to open, prefabs to add.
/// What was chosen lately comes first.
class Finder {
public:
    enum class What : unsigned char { Files, Commands, Scenes, Prefabs };
    static constexpr std::size_t kMostRows = 200;
    static constexpr std::size_t kMostRecent = 20;

    /// Looks through the project and the open scene anew.
    void open(const Workspace& workspace, What what);
    /// What was typed. For files: ">" first searches commands, "@" entities only, as hands know it.
    void search(const Workspace& workspace, std::string typed);

    [[nodiscard]] What what() const { return what_; }
    [[nodiscard]] const std::vector<FinderRow>& rows() const { return rows_; }
    [[nodiscard]] const FinderItem& item(const FinderRow& row) const { return items_[row.item]; }
    /// More than the rows show.
    [[nodiscard]] std::size_t found() const { return found_; }

    std::size_t chosen = 0;  ///< row
    /// Up and down, from the last to the first and back.
    void step(int by);

    /// Does what the chosen row stands for: runs a command, selects and frames an entity, shows a file, adds
    /// a prefab. A scene is only named, for the window to ask about unsaved changes first.
    /// @return path of the scene to open, or empty
    std::string choose(Workspace& workspace);
    /// Kinds and ids of what was chosen, the last one first.
    [[nodiscard]] const std::vector<std::string>& recent() const { return recent_; }

private:
    void collectFiles(const Workspace& workspace);
    void collectScenes(const Workspace& workspace);
    void collectPrefabs(const Workspace& workspace);
    void collectEntities(const Workspace& workspace);
    void collectCommands(const Workspace& workspace);
    void collect(const Workspace& workspace, What what);
    [[nodiscard]] std::size_t recency(const FinderItem& item) const;
    /// The chosen row is not the scene that is open already.
    void leaveOpenScene(const Workspace& workspace);

    What what_ = What::Files;
    What collected_ = What::Files;
    std::vector<FinderItem> items_;
    std::vector<std::size_t> recencies_;  // of each item; kMostRecent for none
    std::vector<FinderRow> rows_;
    std::size_t found_ = 0;
    std::vector<std::string> recent_;
};

}  // namespace plumb::editor
