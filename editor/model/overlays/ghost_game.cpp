#include "editor/model/overlays/ghost_game.hpp"

#include "ecs/world.hpp"
#include "editor/model/workspace.hpp"
#include "scene/components/scene_entity.hpp"

namespace plumb::editor {
namespace {

/// Maps scene ids to entities by a linear search over the world; too slow for many lookups in a frame.
class NamesIn final : public ObjectNames {
public:
    explicit NamesIn(const World& world) : world_{world} {}
    [[nodiscard]] EntityId find(ObjectId id) const override { return entityIn(world_, id); }
    [[nodiscard]] ObjectId idOf(EntityId entity) const override {
        const auto* part = world_.find<SceneEntity>(entity);
        return part == nullptr ? ObjectId{} : ObjectId{part->id};
    }

private:
    const World& world_;
};

}  // namespace

EntityId entityIn(const World& world, ObjectId id) {
    EntityId found;
    world.each<const SceneEntity>([&](EntityId entity, const SceneEntity& part) {
        if (part.id == id.value) found = entity;
    });
    return found;
}

PlaySession* GhostGame::fresh(Workspace& workspace) {
    if (!workspace.makeSession) return nullptr;
    const std::string& scene = workspace.document.scenePath;
    const std::string text = workspace.text();
    if (session_ != nullptr && scene_ == scene && session_->reload(scene, text)) return session_.get();
    session_ = workspace.makeSession(scene, text);
    scene_ = scene;
    return session_.get();
}

PlaySession* GhostGame::now(Workspace& workspace) {
    if (!workspace.play.running()) return fresh(workspace);
    return at(workspace, workspace.play.ticks());
}

PlaySession* GhostGame::at(Workspace& workspace, std::int64_t tick) {
    const PlayMode& play = workspace.play;
    if ((session_ == nullptr || scene_ != workspace.document.scenePath) && fresh(workspace) == nullptr)
        return nullptr;
    World& world = session_->world();
    if (tick == play.ticks()) {
        if (snapshot_ == nullptr) snapshot_ = std::make_unique<Snapshot>();
        play.world().save(*snapshot_);
        world.restore(*snapshot_);
        session_->restored();
        return session_.get();
    }
    const PlayRecording::Keyframe& keyframe = play.recording().before(tick);
    world.restore(*keyframe.world);
    session_->restored();
    play.edits().replay(world, NamesIn{world}, keyframe.tick);
    for (std::int64_t at = keyframe.tick; at < tick; ++at) playRecorded(workspace, at);
    return session_.get();
}

void GhostGame::playRecorded(const Workspace& workspace, std::int64_t tick) {
    const PlayMode& play = workspace.play;
    session_->tick(play.recording().inputAfter(tick));
    play.edits().replay(session_->world(), NamesIn{session_->world()}, tick + 1);
}

}  // namespace plumb::editor
