#pragma once

#include "editor/ui/dialogs/keys_page.hpp"

namespace plumb::editor::ui {

/// What a person chooses for all projects: the look, the keys, how the hands work.
class PreferencesDialog {
public:
    void open() { open_ = true; }
    void draw(Ui& ui);
    /// @return whether it took the event for itself
    bool take(KeyBindings& keys, const Event& event) { return keysPage_.take(keys, event); }

private:
    enum class Page : unsigned char { Look, Keys, Editing };

    void drawPages(Ui& ui);
    void drawLook(Ui& ui);
    static void drawEditing(Ui& ui);

    Page page_ = Page::Look;
    KeysPage keysPage_;
    bool open_ = false;
    float scale_ = 0.0f;     ///< in the hand, percent; taken over when the slider is let go
    float textSize_ = 0.0f;  ///< the same, px
};

}  // namespace plumb::editor::ui
