#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assets/asset_store.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

/// What the editor shows while no project is open, and where one goes to open another: recent projects, and
/// what a new one may begin with. What it chooses it asks for by WindowRequest::OpenProject.
class WelcomeScreen {
public:
    /// @param folder  one without a project, for which one is to be made; empty: none
    void open(Ui& ui, const std::string& folder = {});
    /// Without a project there is nowhere to go back to.
    void close(const Ui& ui) { shown_ = ui.workspace.project.isNone; }
    [[nodiscard]] bool shown() const { return shown_; }
    /// @param size  px of the window
    void draw(Ui& ui, ImVec2 size);

private:
    struct Recent {
        std::string folder;
        std::string name;
        bool there = true;
        TextureId picture;
        bool hasPicture = false;
    };

    void readRecent(Ui& ui);
    void drawTitle(Ui& ui, ImVec2 at, float width);
    void drawNew(Ui& ui);
    void drawTemplate(Ui& ui, std::size_t index);
    void drawRecent(Ui& ui);
    void drawRecentRow(Ui& ui, std::size_t index);
    void drawOpen(Ui& ui);
    void follow();
    void create(Ui& ui);
    void openFolder(Ui& ui, const std::string& folder);

    bool shown_ = false;
    bool focus_ = false;  ///< the name shall take the keyboard
    std::vector<Recent> recent_;
    std::size_t template_ = 0;
    std::string name_;
    std::string folder_;       ///< of the new project
    bool ownFolder_ = false;   ///< written by the person; else it follows the name
    std::string place_;        ///< the folder to open
    std::string message_;      ///< what was wrong with the new one
    std::string openMessage_;  ///< what was wrong with the one to open
};

}  // namespace plumb::editor::ui
