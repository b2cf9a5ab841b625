// CPU time of a frame of the editor with a large scene: panels, overlays, sprites, and submitting all of them
// to a device that draws nothing.

#include <cstdio>
#include <functional>
#include <string>
#include <utility>

#include "app/engine_types.hpp"
#include "core/clock.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/tools/transform_drag.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/name.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/transform.hpp"
#include "scene/files/scene_file.hpp"
#include "tests/bench/open_editor.hpp"

namespace plumb::bench {
namespace {

constexpr std::string_view kPath = "scenes/large.scene.json";
constexpr double kLimit = 8e-3;  // s: maximum time of a frame
constexpr float kSide = 2e4f;    // px: side of the scene

/// Returns a scene file of `count` entities; every tenth entity is the parent of the next nine.
std::string sceneOf(std::size_t count) {
    const TypeRegistry types = engineTypes();
    World world{types};
    Random random = Random::seeded(1);
    const SceneId scene = addScene(world, kPath);
    Entity parent;
    for (std::size_t i = 0; i < count; ++i) {
        const Entity entity = world.createEntity();
        entity.addComponent<SceneEntity>(SceneEntity{newStableId(random), static_cast<int>(i), scene});
        entity.addComponent<Name>(Name{world.texts().add(format("thing {}", i))});
        entity.addComponent<Transform>(random.between(0.0f, kSide), random.between(0.0f, kSide));
        entity.addComponent<Sprite>().width = 16;
        entity.addComponent<BoxCollider>(16, 16);
        if (i % 10 == 0) {
            parent = entity;
        } else {
            setParent(world, entity.id(), parent.id());
        }
    }
    return sceneToJson(world, {types}, scene);
}

/// Measures frames of one scene; each call of add() makes a row of the table.
class Frames {
public:
    Frames(OpenEditor& editor, std::size_t count, const Options& options)
        : editor_{editor},
          count_{count},
          rounds_{options.quick          ? 3
                  : options.rest.empty() ? 60
                                         : 600},
          wanted_{options.rest.empty() ? std::string{} : options.rest.front()},
          table_{"a frame of the editor"} {}

    void add(const std::string& name, const std::function<void()>& run) {
        if (name.find(wanted_) == std::string::npos) return;
        for (int i = 0; i < 3; ++i) run();  // updates caches after a change
        table_.add(format("{} ({} shapes)", name, editor_.drawn().sprites), count_,
                   timesOf(rounds_, &threadSeconds, [&](int) { run(); }), kLimit);
    }
    /// Runs a frame with the mouse near the center of the scene, at a slightly different position every time.
    void moveMouse() {
        step_ = (step_ + 1) % 100;
        const auto at = static_cast<float>(step_);
        editor_.moveTo(editor_.middle() + Vec2{at, at * 0.5f});
    }
    [[nodiscard]] const TimeTable& table() const { return table_; }

private:
    OpenEditor& editor_;
    std::size_t count_;
    int rounds_;
    std::string wanted_;  // only rows whose name contains this are run
    TimeTable table_;
    int step_ = 0;
};

void look(Frames& frames, OpenEditor& editor, const std::string& how) {
    frames.add(how + ", at rest", [&] { editor.frame(); });
    frames.add(how + ", mouse over the scene", [&] { frames.moveMouse(); });
}

void addViews(Frames& frames, OpenEditor& editor) {
    editor::Workspace& workspace = editor.workspace();
    const auto both = [&](const std::string& how) {
        runAction(workspace, "view.all");
        look(frames, editor, how + ", all in sight");
        workspace.view.show({kSide * 0.5f, kSide * 0.5f}, 1.0f);
        look(frames, editor, how + ", near");
    };
    both("scene");
    editor.key(Key::F3);
    both("colliders");
    editor.key(Key::F3);
}

void addSelections(Frames& frames, OpenEditor& editor) {
    editor::Workspace& workspace = editor.workspace();
    editor::Document& document = workspace.document;
    runAction(workspace, "view.all");
    document.selection.set({document.objects()[document.objects().size() / 2]});
    look(frames, editor, "one selected");
    float offset = 0.0f;
    const auto nudgeOnce = [&] {
        nudge(workspace.tools(), {offset = offset > 0.0f ? -1.0f : 1.0f, 0.0f});
        frames.moveMouse();
    };
    frames.add("one entity moved in each frame", nudgeOnce);
    workspace.undo.endGesture();
    std::vector<editor::ObjectId> some{
        document.objects().begin(),
        document.objects().begin() + static_cast<std::ptrdiff_t>(document.objects().size() / 20)};
    document.selection.set(some);
    look(frames, editor, "5 % of the entities selected");
    frames.add("5 % of the entities moved in each frame", nudgeOnce);
    workspace.undo.endGesture();
    document.selection.set(document.objects());
    look(frames, editor, "all selected");
    document.selection.clear();
}

/// Measures frames with edits while the journal is written, and saving.
void addSaving(std::vector<Row>& rows, OpenEditor& editor, std::size_t count, const Options& options) {
    editor::Workspace& workspace = editor.workspace();
    workspace.document.selection.set({workspace.document.objects()[count / 2]});
    TimeTable table{"work with the journal running"};
    float offset = 0.0f;
    const auto edit = [&](int) {
        nudge(workspace.tools(), {offset = offset > 0.0f ? -1.0f : 1.0f, 0.0f});
        editor.frame();
    };
    table.add("frame in which one entity is moved", count, pacedTimesOf(3, options.quick ? 10 : 200, edit),
              1.0 / 60.0);
    workspace.undo.endGesture();
    table.add("save after an edit", count,
              timesOf(options.quick ? 1 : 5, &wallSeconds,
                      [&](int i) {
                          edit(i);
                          workspace.undo.endGesture();
                          static_cast<void>(workspace.save().ok());
                      }),
              1.0);
    rows.insert(rows.end(), table.rows().begin(), table.rows().end());
}

void addFilter(Frames& frames, OpenEditor& editor) {
    editor.click("Scene/filter");
    editor.type("thing 77");
    look(frames, editor, "tree filtered");
}

void addPlaying(Frames& frames, OpenEditor& editor) {
    editor::Workspace& workspace = editor.workspace();
    workspace.startPlaying(true);
    look(frames, editor, "game paused");
    runAction(workspace, "run.pause");
    look(frames, editor, "game playing");
    runAction(workspace, "view.all");
    workspace.followsGame = false;
    look(frames, editor, "game playing, all in sight");
    workspace.document.selection.set(
        {workspace.document.objects().begin(), workspace.document.objects().begin() + 5});
    look(frames, editor, "game playing, five selected");
    workspace.stopPlaying();
    editor.frames(2);
}

}  // namespace

int runEditor(const Options& options) {
    const std::size_t count = options.quick ? 2000 : 100000;
    const TemporaryProject project{"editor_bench"};
    project.write(kPath, sceneOf(count));
    OpenEditor editor{project.root(), kPath};
    Frames frames{editor, count, options};
    addViews(frames, editor);
    addSelections(frames, editor);
    addPlaying(frames, editor);
    addFilter(frames, editor);
    std::vector<Row> rows = frames.table().rows();
    if (options.rest.empty()) {
        addSaving(rows, editor, count, options);
        const std::vector<Row> starts = runStarts(options);
        rows.insert(rows.end(), starts.begin(), starts.end());
    }
    return options.jsonPath.empty() || writeRows(options.jsonPath, rows) ? 0 : 1;
}

}  // namespace plumb::bench
