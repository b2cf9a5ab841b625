#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assets/asset_store.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// The screen to open or create a project, with recent projects and templates; shown first if no project is
/// open. To open one, it sets Workspace::request to OpenProject.
class WelcomeScreen {
public:
    /// Shows the screen. @param folder  folder of the project to create or open; empty: none
    void open(Ui& ui, const std::string& folder = {});
    /// Hides the screen; without an open project it stays.
    void close(const Ui& ui) { shown_ = ui.workspace.project.isNone; }
    [[nodiscard]] bool shown() const { return shown_; }
    /// @param size  size of the window, px
    void draw(Ui& ui, ImVec2 size);

private:
    struct Recent {
        std::string folder;
        std::string name;
        bool there = true;  ///< the folder still contains a project
        TextureId picture;  ///< preview image
        bool hasPicture = false;
    };

    void readRecent(Ui& ui);
    void drawTitle(Ui& ui, ImVec2 at, float width);
    void drawNew(Ui& ui);
    void drawTemplate(Ui& ui, std::size_t index);
    void drawRecent(Ui& ui);
    void drawRecentRow(Ui& ui, std::size_t index);
    void drawOpen(Ui& ui);
    void follow();  ///< derives the project's folder from its name, unless the user edited it
    void create(Ui& ui);
    void openFolder(Ui& ui, const std::string& folder);

    bool shown_ = false;
    bool focus_ = false;  ///< the name field gets the keyboard focus in the next frame
    std::vector<Recent> recent_;
    std::size_t template_ = 0;  ///< index of the selected template
    std::string name_;          ///< name of the new project
    std::string folder_;        ///< folder of the new project
    bool ownFolder_ = false;    ///< the user edited the folder; otherwise it follows the name
    std::string place_;         ///< text of the field for the folder to open
    std::string message_;       ///< error of creating a project
    std::string openMessage_;   ///< error of opening a folder
};

}  // namespace plumb::editor::ui
