#pragma once

#include <string>
#include <vector>

#include "assets/asset_store.hpp"
#include "ecs/world.hpp"

namespace plumb::editor {

/// Previews the state machine of an animation file, with parameters that the user sets. It runs the engine's
/// AnimationSystem in a world of one entity, so it behaves as in a game.
class MachinePreview {
public:
    explicit MachinePreview(AssetStore& assets);

    /// Selects the animation file; another one than before restarts the preview.
    void show(AnimationId animation);
    /// Advances by the time since the last frame, after applying changes of the file.
    void advance(double seconds);
    /// Restarts from the first state with the initial parameter values.
    void restart();
    /// Enters a state regardless of transitions.
    void enter(int state);

    [[nodiscard]] int state() const;  ///< index of the present state; -1: none
    /// The present frame, null if there is none.
    [[nodiscard]] const AnimationFrame* frame() const;
    [[nodiscard]] float value(int parameter) const;
    void setValue(int parameter, float value);

private:
    static constexpr double kStep = 1.0 / 60.0;  // s

    [[nodiscard]] const AnimationSet& set() const { return assets_.animation(animation_); }
    void follow();

    AssetStore& assets_;
    World world_;
    EntityId entity_;
    AnimationId animation_;
    std::vector<AnimationParameter> parameters_;  // parameters of the file at the last step
    double rest_ = 0.0;                           // s: playback time not yet simulated
};

}  // namespace plumb::editor
