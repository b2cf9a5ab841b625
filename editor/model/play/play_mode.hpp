#pragma once

#include <memory>
#include <string>

#include "core/result.hpp"
#include "editor/model/document/id_table.hpp"
#include "editor/model/document/object_id.hpp"
#include "editor/model/play/play_edits.hpp"
#include "editor/model/play/play_recording.hpp"
#include "input/input_frame.hpp"

namespace plumb {
class AssetStore;
struct ContentChange;
class World;
}  // namespace plumb

namespace plumb::editor {

/// A game that runs in its own world. The next tick depends only on that world and the input.
class PlaySession {
public:
    virtual ~PlaySession() = default;
    [[nodiscard]] virtual World& world() = 0;
    /// The store of the game's textures and other assets; null: the game uses the editor's store.
    [[nodiscard]] virtual AssetStore* assets() { return nullptr; }
    /// Advances by one tick of 1/60 s.
    virtual void tick(const InputFrame& input) = 0;
    /// Called after the world was restored from a snapshot; updates the state outside of the world.
    virtual void restored() {}
    /// Called after the project's code was replaced by another version; converts the world.
    virtual void contentChanged(const ContentChange&) {}
    /// Restarts with new content of the scene file.
    /// @return false if this is not possible; the caller must create a new session then
    virtual bool reload([[maybe_unused]] const std::string& path, [[maybe_unused]] const std::string& text) {
        return false;
    }
};

/// Listener that is called before and after every tick, including replayed ones.
class TickListener {
public:
    virtual ~TickListener() = default;
    virtual void before(World& world) = 0;
    /// @param tick   number of ticks since the start of the game, including this one
    /// @param again  true if the tick is replayed from the recording
    virtual void after(World& world, std::int64_t tick, bool again) = 0;
};

/// May stop a tick in its middle: the debugger of scripts. Not called for the ticks that PlayMode::seek()
/// replays.
class TickStopper {
public:
    virtual ~TickStopper() = default;
    /// Called before a tick.
    /// @param again   true if the tick is replayed from the recording
    /// @param goesOn  the game was inside of this tick, which starts again now
    /// @return false if the tick cannot be stopped
    virtual bool begins(World& world, std::int64_t tick, bool again, bool goesOn) = 0;
    /// Called after each tick for which begins() returned true.
    /// @return the world at the place where the tick was stopped; null: it has run to its end
    virtual const Snapshot* ends() = 0;
};

/// Runs the scene of the document in a second world, which is discarded on stop. The document does not
/// change, so nothing must be restored. The game can be rewound by up to 30 s and continued from any tick.
class PlayMode final : public ObjectNames {
public:
    /// @param session  a new session, with a copy of the scene in its world
    void start(std::unique_ptr<PlaySession> session, bool paused = false);
    void stop();

    [[nodiscard]] bool running() const { return session_ != nullptr; }
    [[nodiscard]] bool paused() const { return paused_; }
    [[nodiscard]] std::size_t games() const { return games_; }  ///< number of games started so far
    /// The world of the running game. @pre running()
    [[nodiscard]] World& world() const { return session_->world(); }
    [[nodiscard]] AssetStore* assets() const { return session_ ? session_->assets() : nullptr; }
    [[nodiscard]] EntityId find(ObjectId id) const override;
    [[nodiscard]] ObjectId idOf(EntityId entity) const override;

    // Time.

    [[nodiscard]] std::int64_t ticks() const { return ticks_; }  ///< the current tick, also in the past
    /// Runs as many ticks as fit into the time since the last frame; none while paused.
    /// @return interpolation factor for drawing, between the last two ticks (0..1)
    float advance(double seconds, const InputFrame& input);
    /// Runs one tick, also while paused. In the past it replays the recorded tick and ignores `input`.
    void step(const InputFrame& input);
    /// Pauses or continues. Continuing from a tick in the past discards the recorded ticks after it.
    void setPaused(bool paused);
    static constexpr int kSlowest = -3;  ///< lowest power for `setSpeed`: 1/8 of normal speed
    static constexpr int kFastest = 3;   ///< highest power for `setSpeed`: 8 times normal speed
    /// Sets the speed to 2^power times normal speed. @param power  0: normal speed
    void setSpeed(int power);
    [[nodiscard]] int speed() const { return speed_; }

    // Rewinding.

    [[nodiscard]] std::int64_t oldest() const { return recording_.oldest(); }
    [[nodiscard]] std::int64_t newest() const { return recording_.newest(); }
    [[nodiscard]] bool inPast() const { return running() && ticks_ < newest(); }
    /// Restores the world to its state after this tick, or after the nearest recorded one, and pauses.
    void seek(std::int64_t tick);
    /// Replays the recorded ticks from the current one on, and pauses after the newest. No effect outside the
    /// past.
    void playReplay();
    [[nodiscard]] bool isReplaying() const { return replaying_; }
    [[nodiscard]] const PlayRecording& recording() const { return recording_; }

    TickListener* tickListener = nullptr;  ///< listener of all ticks; may be null
    TickStopper* tickStopper = nullptr;    ///< may be null

    /// True while a tick is stopped in its middle: the game is paused, ticks() is the tick before, and the
    /// world shows what has happened so far. The tick starts again when the game goes on.
    [[nodiscard]] bool insideTick() const { return inside_; }
    /// Restores the world after ticks(), if a tick is stopped in its middle.
    void leaveTick();

    /// Converts the running game to another version of the project's code. The recording starts anew: the
    /// past was simulated by the version before. @pre running()
    void contentChanged(const ContentChange& change);

    // Changes by the user.

    /// Sets a field in the running game. In the past this discards the recorded ticks after the current one.
    void edit(ObjectId object, const TypeInfo& type, const FieldInfo& field, const FieldValue& value);
    [[nodiscard]] const PlayEdits& edits() const { return edits_; }

private:
    void tick(const InputFrame& input, bool again);
    bool tryTick(const InputFrame& input, bool again, bool goesOn);
    void enterTick(const Snapshot& middle);
    void playRecorded();
    void finishRecorded();
    void branch(std::int64_t lastInput);

    std::unique_ptr<PlaySession> session_;
    PlayRecording recording_;
    PlayEdits edits_;
    std::size_t games_ = 0;
    bool paused_ = false;
    bool replaying_ = false;
    int speed_ = 0;  // power of two
    std::int64_t ticks_ = 0;
    bool inside_ = false;                 // a tick is stopped in its middle
    Snapshot beforeTick_;                 // of the tick that is stopped
    double rest_ = 0.0;                   // s: elapsed time that is not simulated yet
    mutable IdTable<EntityId> entities_;  // entities by scene id, at the tick `indexed_`
    mutable std::int64_t indexed_ = -1;   // tick at which `entities_` was built; -1: not built
};

}  // namespace plumb::editor
