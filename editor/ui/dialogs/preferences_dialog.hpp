#pragma once

#include "editor/ui/dialogs/keys_page.hpp"

namespace plumb::editor::ui {

/// The dialog for the user's settings for all projects: appearance, keyboard shortcuts and editing.
class PreferencesDialog {
public:
    void open() { open_ = true; }
    void draw(Ui& ui);
    /// Handles an event while the page "Keys" waits for a new shortcut.
    /// @return true if the event was used and must have no other effect
    bool take(KeyBindings& keys, const Event& event) { return keysPage_.take(keys, event); }

private:
    enum class Page : unsigned char { Look, Keys, Editing };

    void drawPages(Ui& ui);
    void drawLook(Ui& ui);
    static void drawEditing(Ui& ui);

    Page page_ = Page::Look;
    KeysPage keysPage_;
    bool open_ = false;
    float scale_ = 0.0f;     ///< %: value of the scale slider during a drag; otherwise 0
    float textSize_ = 0.0f;  ///< px: value of the text size slider during a drag; otherwise 0
};

}  // namespace plumb::editor::ui
