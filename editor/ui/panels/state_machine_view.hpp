#pragma once

#include "editor/model/assets/machine_preview.hpp"
#include "editor/ui/panels/machine_details.hpp"

namespace plumb {
struct Animator;
}

namespace plumb::editor::ui {

/// The page "States" of the animation panel: the graph with what it plays, the parameters, and what is
/// chosen of them.
class StateMachineView {
public:
    explicit StateMachineView(AnimationEdit& file);

    /// Nothing is chosen, and the preview begins anew: another file was opened.
    void begin();
    /// The parameters, each with what it is in the preview, or in the game that plays.
    void drawParameters(Ui& ui);
    /// The graph and, beside it or below it, what is chosen.
    /// @param clip  that a new state plays
    void drawGraph(Ui& ui, int clip);

private:
    void drawAddParameter(Ui& ui);
    void drawParameter(Ui& ui, int index);
    void drawValue(Ui& ui, int index);
    void drawBar(Ui& ui, int clip);
    void drawPicture(Ui& ui, ImVec2 at, float side);
    void take(const GraphHands& hands);
    /// After undo what was chosen may be gone.
    void forgetWhatIsGone();
    /// Del takes out what is chosen here, and not what is selected in the scene.
    void waitForKeys(Ui& ui);
    [[nodiscard]] bool takeKey(const Event& event);
    /// Of the game that plays: of what is selected, or else the first that plays this file. Null: none.
    [[nodiscard]] const Animator* inGame() const;

    AnimationEdit& file_;
    StateMachineEdit edit_;
    MachinePreview preview_;
    MachineDetails details_;
    MachinePart chosen_;
    bool waits_ = false;
    int keysSeen_ = -2;  // frame in which keys could last be meant for this
};

}  // namespace plumb::editor::ui
