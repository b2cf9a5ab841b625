#pragma once

#include <string>
#include <vector>

#include "assets/asset_store.hpp"
#include "ecs/world.hpp"

namespace plumb::editor {

/// Plays the state machine of an animation file while the game does not run, with parameters that the person
/// sets. It is the engine's own system in a world of one entity, so what is shown is what a game would do.
class MachinePreview {
public:
    explicit MachinePreview(AssetStore& assets);

    /// Which file is played; another one begins anew.
    void show(AnimationId animation);
    /// Goes on by the time since the last frame. What was changed in the file counts from here on.
    void advance(double seconds);
    /// From the first state, with the parameters as they are at the start.
    void restart();
    /// Goes to a state, whatever the transitions say.
    void enter(int state);

    [[nodiscard]] int state() const;  ///< -1 when there is none
    /// What is seen now; null when there is nothing.
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
    std::vector<AnimationParameter> parameters_;  // as they were in the last step
    double rest_ = 0.0;                           // s that no step has used yet
};

}  // namespace plumb::editor
