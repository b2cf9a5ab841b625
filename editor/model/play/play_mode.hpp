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
class World;
}  // namespace plumb

namespace plumb::editor {

/// A game that runs in a world of its own. All that the next tick depends on is in that world.
class PlaySession {
public:
    virtual ~PlaySession() = default;
    [[nodiscard]] virtual World& world() = 0;
    /// Where the game finds its pictures; null: where the editor finds them.
    [[nodiscard]] virtual AssetStore* assets() { return nullptr; }
    /// Advances by one tick of 1/60 s.
    virtual void tick(const InputFrame& input) = 0;
    /// The world was put back to another moment: what lies beside it follows.
    virtual void restored() {}
    /// Begins anew with another text of the scene. @return false when it cannot; make another session then
    virtual bool reload([[maybe_unused]] const std::string& path, [[maybe_unused]] const std::string& text) {
        return false;
    }
};

/// Hears of every tick that is played, also of those that are played again to look at the past.
class TickWatch {
public:
    virtual ~TickWatch() = default;
    virtual void before(World& world) = 0;
    /// @param tick   the number of ticks since the game began, with this one
    /// @param again  it was played before
    virtual void after(World& world, std::int64_t tick, bool again) = 0;
};

/// Plays the document in a second world; stopping throws that world away. The document is never touched, so
/// there is nothing to undo. The last 30 s can be gone back to, looked at, and gone on from.
class PlayMode final : public ObjectNames {
public:
    /// @param session  a fresh one, with a copy of the scene in its world
    void start(std::unique_ptr<PlaySession> session, bool paused = false);
    void stop();

    [[nodiscard]] bool running() const { return session_ != nullptr; }
    [[nodiscard]] bool paused() const { return paused_; }
    /// The world that plays. @pre running()
    [[nodiscard]] World& world() const { return session_->world(); }
    [[nodiscard]] AssetStore* assets() const { return session_ ? session_->assets() : nullptr; }
    [[nodiscard]] EntityId find(ObjectId id) const override;
    [[nodiscard]] ObjectId idOf(EntityId entity) const override;

    // Time.

    [[nodiscard]] std::int64_t ticks() const { return ticks_; }  ///< the one that is looked at
    /// Plays as many ticks as fit into the time since the last frame; none while paused.
    /// @return how far the drawing is between the last two ticks (ratio, 0..1)
    float advance(double seconds, const InputFrame& input);
    /// One tick, also while paused. In the past it is the one that was, whatever the hands do now.
    void step(const InputFrame& input);
    /// Going on from a moment of the past makes another future of it.
    void setPaused(bool paused);
    static constexpr int kSlowest = -3;  ///< 1/8
    static constexpr int kFastest = 3;   ///< 8 times
    /// @param power  of two: 0 is the speed that the game is made for
    void setSpeed(int power);
    [[nodiscard]] int speed() const { return speed_; }

    // The past.

    [[nodiscard]] std::int64_t oldest() const { return recording_.oldest(); }
    [[nodiscard]] std::int64_t newest() const { return recording_.newest(); }
    [[nodiscard]] bool inPast() const { return running() && ticks_ < newest(); }
    /// Shows the world as it was after this tick, or the nearest one that is recorded, and pauses.
    void seek(std::int64_t tick);
    /// From the past: plays what was recorded, as it was, and stops where it ends.
    void watch();
    [[nodiscard]] bool watching() const { return watching_; }
    [[nodiscard]] const PlayRecording& recording() const { return recording_; }

    TickWatch* watchTicks = nullptr;  ///< null: not watched

    // Changes by hand.

    /// Sets a field in the running game. In the past this makes another future.
    void edit(ObjectId object, const TypeInfo& type, const FieldInfo& field, const FieldValue& value);
    [[nodiscard]] const PlayEdits& edits() const { return edits_; }

private:
    void tick(const InputFrame& input, bool again);
    void playRecorded();
    void branch();

    std::unique_ptr<PlaySession> session_;
    PlayRecording recording_;
    PlayEdits edits_;
    bool paused_ = false;
    bool watching_ = false;
    int speed_ = 0;
    std::int64_t ticks_ = 0;
    double rest_ = 0.0;                   // s that no tick has used yet
    mutable IdTable<EntityId> entities_;  // as they were at `indexed_`
    mutable std::int64_t indexed_ = -1;   // tick
};

}  // namespace plumb::editor
