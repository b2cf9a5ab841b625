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
    bool take(KeyBindings& keys, const Event& event) {
        const bool taken = keysPage_.take(keys, event);
        tookKey_ |= taken;
        return taken;
    }
    /// True while the page "Keys" waits for the user to press a new shortcut.
    [[nodiscard]] bool listening() const { return keysPage_.listening(); }

private:
    enum class Page : unsigned char { Look, Keys, Editing };

    void drawPages(Ui& ui);
    void drawLook(Ui& ui);
    static void drawEditing(Ui& ui);

    Page page_ = Page::Look;
    KeysPage keysPage_;
    bool open_ = false;
    bool tookKey_ = false;   ///< the page "Keys" has used an event of this frame
    float scale_ = 0.0f;     ///< %: value of the scale slider during a drag; otherwise 0
    float textSize_ = 0.0f;  ///< px: value of the text size slider during a drag; otherwise 0
};

}  // namespace plumb::editor::ui
