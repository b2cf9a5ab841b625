#pragma once

#include <memory>
#include <unordered_map>

#include "core/result.hpp"
#include "editor/model/object_id.hpp"
#include "input/input_frame.hpp"

namespace plumb {
class AssetStore;
class World;
}  // namespace plumb

namespace plumb::editor {

/// A game that runs in a world of its own.
class PlaySession {
public:
    virtual ~PlaySession() = default;
    [[nodiscard]] virtual World& world() = 0;
    /// Where the game finds its pictures; null: where the editor finds them.
    [[nodiscard]] virtual AssetStore* assets() { return nullptr; }
    /// Advances by one tick of 1/60 s.
    virtual void tick(const InputFrame& input) = 0;
};

/// Plays the document in a second world; stopping throws that world away. The document is never touched, so
/// there is nothing to undo.
class PlayMode final : public ObjectNames {
public:
    /// @param session  a fresh one, with a copy of the scene in its world
    void start(std::unique_ptr<PlaySession> session);
    void stop();
    void setPaused(bool paused) { paused_ = paused; }

    [[nodiscard]] bool running() const { return session_ != nullptr; }
    [[nodiscard]] bool paused() const { return paused_; }
    /// The world that plays. @pre running()
    [[nodiscard]] World& world() const { return session_->world(); }
    [[nodiscard]] AssetStore* assets() const { return session_ ? session_->assets() : nullptr; }
    [[nodiscard]] EntityId find(ObjectId id) const override;
    [[nodiscard]] ObjectId idOf(EntityId entity) const override;
    [[nodiscard]] std::int64_t ticks() const { return ticks_; }

    /// Plays as many ticks as fit into the time since the last frame; none while paused.
    /// @return how far the drawing is between the last two ticks (ratio, 0..1)
    float advance(double seconds, const InputFrame& input);
    /// One tick, also while paused.
    void step(const InputFrame& input);

private:
    std::unique_ptr<PlaySession> session_;
    bool paused_ = false;
    std::int64_t ticks_ = 0;
    double rest_ = 0.0;                                             // s that no tick has used yet
    mutable std::unordered_map<std::uint64_t, EntityId> entities_;  // as they were at `indexed_`
    mutable std::int64_t indexed_ = -1;                             // tick
};

}  // namespace plumb::editor
