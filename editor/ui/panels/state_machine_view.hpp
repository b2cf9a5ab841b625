#pragma once

#include "editor/model/assets/machine_preview.hpp"
#include "editor/ui/panels/machine_details.hpp"

namespace plumb {
struct Animator;
}

namespace plumb::editor::ui {

/// The page "States" of the animation panel: the state graph with a
/// preview, the parameters, and the details of the selected part.
class StateMachineView {
public:
    explicit StateMachineView(AnimationEdit& file);

    /// Clears the selection and restarts the preview. Call it after another file was opened.
    void begin();
    /// Draws the parameters with their values in the preview, or in the running game.
    void drawParameters(Ui& ui);
    /// Draws the graph and, beside or below it, the details of the selected part.
    /// @param clip  index of the clip that a new state plays
    void drawGraph(Ui& ui, int clip);

private:
    void drawAddParameter(Ui& ui);
    void drawParameter(Ui& ui, int index);
    void drawValue(Ui& ui, int index);
    void drawBar(Ui& ui, int clip);
    void drawPicture(Ui& ui, ImVec2 at, float side);
    void take(const GraphInput& hands);  ///< applies the user's actions on the graph
    /// Clears the selection if the selected part no longer exists, as after undo.
    void dropStaleSelection();
    /// Makes the key Delete remove the selected part of the machine, not the selected entities of the scene.
    void waitForKeys(Ui& ui);
    [[nodiscard]] bool takeKey(const Event& event);
    /// Returns an animator of the running game that plays this file: that of
    /// a selected entity, or else the first one found. Null if there is none.
    [[nodiscard]] const Animator* inGame() const;

    AnimationEdit& file_;
    StateMachineEdit edit_;
    MachinePreview preview_;
    MachineDetails details_;
    MachinePart chosen_;
    bool waits_ = false;  // ui.takeEvent is set by this view
    int keysSeen_ = -2;   // last frame in which the graph was drawn, and so may receive keys
};

}  // namespace plumb::editor::ui
