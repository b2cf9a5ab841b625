// What a frame of the editor costs in a large scene, without drawing on a graphics card.

#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/engine_types.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "editor/model/tools/transform_drag.hpp"
#include "editor/model/workspace.hpp"
#include "editor/ui/editor_window.hpp"
#include "scene/components/box_collider.hpp"
#include "scene/components/name.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/sprite.hpp"
#include "scene/components/transform.hpp"
#include "scene/scene_file.hpp"
#include "tests/bench/bench.hpp"

namespace plumb::bench {
namespace {

using editor::ObjectId;

constexpr std::string_view kPath = "scenes/large.scene.json";
constexpr double kNanoseconds = 1e9;
constexpr double kLimit = 8e6;  // ns of a frame

/// Every tenth entity has nine below it.
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
        entity.addComponent<Transform>(random.between(0.0f, 2e4f), random.between(0.0f, 2e4f));
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

/// A project in a temporary folder with one large scene, and the window of the editor on it.
class LargeScene {
public:
    explicit LargeScene(std::size_t count) : root_{makeFolder()}, types_{engineTypes()}, assets_{root_} {
        static_cast<void>(writeFile(root_ / kPath, sceneOf(count)).ok());
        workspace_ = std::make_unique<editor::Workspace>(types_, assets_, editor::ProjectFolder{root_});
        window_ = std::make_unique<editor::ui::EditorWindow>(*workspace_, log_, nullptr, Path{});
        static_cast<void>(workspace_->open(kPath).ok());
        for (int i = 0; i < 4; ++i) frame({});
    }
    ~LargeScene() {
        window_.reset();
        workspace_.reset();
        std::filesystem::remove_all(root_);
    }
    [[nodiscard]] editor::Workspace& workspace() { return *workspace_; }
    void frame(const std::vector<Event>& events) { window_->frame({events}); }
    /// The mouse over the middle of the scene, a little further with every frame.
    void moveMouse() {
        const AABB view = window_->widgets().find("Viewport")->box;
        step_ = (step_ + 1) % 100;
        const auto at = static_cast<float>(step_);
        frame({{.kind = EventKind::MouseMoved, .position = view.center() + Vec2{at, at * 0.5f}}});
    }

private:
    static Path makeFolder() {
        Path folder = std::filesystem::temp_directory_path() / "plumb_editor_bench";
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder / "scenes");
        return folder;
    }

    Path root_;
    TypeRegistry types_;
    AssetStore assets_;
    editor::LogBook log_;
    std::unique_ptr<editor::Workspace> workspace_;
    std::unique_ptr<editor::ui::EditorWindow> window_;
    int step_ = 0;
};

void measure(const std::string& name, std::size_t count, const std::function<void()>& run,
             const Options& options, std::vector<Row>& rows) {
    const Contestant contestant{{}, run};
    const Timing timing = race({&contestant, 1}, options).front();
    rows.push_back({name, count, timing.minimum * kNanoseconds, timing.median * kNanoseconds, 0.0, kLimit});
    print(rows.back());
    std::printf("    %s ms a frame, at most %s ms\n", fixedText(timing.minimum * 1e3, 3).c_str(),
                fixedText(kLimit * 1e-6, 1).c_str());
    std::fflush(stdout);
}

}  // namespace

int runEditor(const Options& options) {
    const std::size_t count = options.quick ? 2000 : 100000;
    LargeScene scene{count};
    editor::Workspace& workspace = scene.workspace();
    editor::Document& document = workspace.document;
    std::vector<Row> rows;
    printHeader();
    const auto add = [&](const char* name, const std::function<void()>& run) {
        measure(format("editor {}", name), count, run, options, rows);
    };
    add("frame at rest", [&] { scene.frame({}); });
    add("mouse over the scene", [&] { scene.moveMouse(); });
    document.selection.set({document.objects()[count / 2]});
    add("one selected, mouse over the scene", [&] { scene.moveMouse(); });
    float way = 0.0f;
    add("one moved in each frame", [&] {
        nudge(workspace.tools(), {way = way > 0.0f ? -1.0f : 1.0f, 0.0f});
        scene.moveMouse();
    });
    workspace.undo.endGesture();
    document.selection.set(document.objects());
    add("all selected, mouse over the scene", [&] { scene.moveMouse(); });
    return options.jsonPath.empty() || writeRows(options.jsonPath, rows) ? 0 : 1;
}

}  // namespace plumb::bench
