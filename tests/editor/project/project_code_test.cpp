#include "editor/model/project/editor_options.hpp"
#include "editor/model/project/project_code.hpp"

#include <gtest/gtest.h>

#include "editor/model/commands/set_field.hpp"
#include "editor/model/prefabs/make_prefab.hpp"
#include "editor/model/prefabs/override_list.hpp"
#include "editor/model/project/project_session.hpp"
#include "editor/templates/project_templates.hpp"
#include "platform/shared_library.hpp"
#include "scene/components.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

// A project whose scenes contain components of its own code, in versions that replace each other.

namespace plumb::editor {
namespace first {

struct Walker {
    float speed = 200.0f;
    float jump = 420.0f;
    int steps = 0;

    static void describe(TypeBuilder<Walker>& type) {
        type.name("Walker");
        type.field<&Walker::speed>("speed");
        type.field<&Walker::jump>("jump");
        type.field<&Walker::steps>("steps").transient();
    }
};

struct WalkerSystem {
    void update(World& world, float) const {
        for (auto [entity, walker] : world.query<Walker>()) ++walker.steps;
    }
};

Module module() {
    Module module;
    module.components<Walker>();
    module.system<WalkerSystem, Walker>();
    return module;
}

}  // namespace first

namespace second {

struct Walker {
    int steps = 0;
    float pace = 1.0f;
    bool tired = true;

    static void describe(TypeBuilder<Walker>& type) {
        type.name("Walker");
        type.field<&Walker::steps>("steps").transient();
        type.field<&Walker::pace>("pace").was("speed");
        type.field<&Walker::tired>("tired");
    }
};

struct WalkerSystem {
    void update(World& world, float) const {
        for (auto [entity, walker] : world.query<Walker>()) walker.steps += 1000;
    }
};

Module module() {
    Module module;
    module.components<Walker>();
    module.system<WalkerSystem, Walker>();
    return module;
}

}  // namespace second

namespace {

class ProjectCodeTest : public ::testing::Test {
protected:
    ProjectCodeTest() {
        const Path folder = home_.path / "game";
        EXPECT_TRUE(createProject(*findTemplate("cpp"), "Game", folder).ok());
        std::filesystem::remove_all(folder / "code");  // the test writes its own versions of the code
        scene_ = *readFile(folder / "scenes/level1.scene.json");
        session = std::move(*ProjectSession::open(folder.string()));
        session->openFirst({});
    }

    [[nodiscard]] Workspace& workspace() { return session->workspace(); }
    [[nodiscard]] ObjectId player() {
        for (const ObjectId id : workspace().document.objects()) {
            if (workspace().document.nameOf(id) == "player") return id;
        }
        return {};
    }
    /// The component in a world, by its type's name; null if the entity has none.
    [[nodiscard]] const void* walkerIn(const World& world, EntityId entity) {
        const TypeInfo* type = workspace().document.types().find("Walker");
        return type == nullptr ? nullptr : world.find(*type, entity);
    }
    template <class T>
    [[nodiscard]] const T* edited() {
        return static_cast<const T*>(
            walkerIn(workspace().document.world, workspace().document.find(player())));
    }
    template <class T>
    [[nodiscard]] const T* played() {
        return static_cast<const T*>(walkerIn(workspace().play.world(), workspace().play.find(player())));
    }
    void setSpeed(float speed) {
        const TypeInfo& type = *workspace().document.types().find("Walker");
        workspace().undo.push(std::make_unique<SetField>(
            type, *type.find("speed"), std::vector<SetField::Change>{{player(), FieldValue::of(speed)}}));
        workspace().undo.endGesture();
    }
    void step(int ticks) {
        for (int i = 0; i < ticks; ++i) workspace().play.step({});
    }

    std::unique_ptr<ProjectSession> session;
    std::string scene_;

private:
    test::TemporaryFolder home_;
};

TEST_F(ProjectCodeTest, unknownComponentsKeepTheirText) {
    EXPECT_EQ(workspace().text(), scene_);
    EXPECT_EQ(edited<first::Walker>(), nullptr);
}

TEST_F(ProjectCodeTest, componentsOfTheCodeAreEditedLikeOthers) {
    session->useCode(first::module());
    ASSERT_NE(edited<first::Walker>(), nullptr);
    EXPECT_EQ(edited<first::Walker>()->speed, 200.0f);
    EXPECT_EQ(workspace().text(), scene_) << "a component that has only defaults is written as before";
    EXPECT_FALSE(workspace().unsaved());

    setSpeed(350.0f);
    EXPECT_EQ(edited<first::Walker>()->speed, 350.0f);
    EXPECT_NE(workspace().text().find("\"speed\": 350"), std::string::npos);
    EXPECT_TRUE(workspace().undo.undo());
    EXPECT_EQ(workspace().text(), scene_);
}

TEST_F(ProjectCodeTest, prefabsAndTheirInstancesContainComponentsOfTheCode) {
    session->useCode(first::module());
    ASSERT_TRUE(makePrefab(workspace(), {player()}, prefabPath("hero")).ok());
    EXPECT_EQ(overrideList(workspace().prefabs(), player()).size(), 0u);
    setSpeed(350.0f);
    const std::vector<OverrideRow> rows = overrideList(workspace().prefabs(), player());
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].type->name, "Walker");
    EXPECT_EQ(rows[0].field, "speed");
    EXPECT_EQ(rows[0].here, "350");
    EXPECT_TRUE(revertOverride(workspace().prefabs(), rows[0]));
    EXPECT_EQ(edited<first::Walker>()->speed, 200.0f);

    setSpeed(350.0f);
    session->useCode(second::module());
    ASSERT_NE(edited<second::Walker>(), nullptr);
    EXPECT_EQ(edited<second::Walker>()->pace, 350.0f) << "the override of the field by its former name";
}

TEST_F(ProjectCodeTest, theInspectorEditsSeveralAtOnceByExpressions) {
    session->useCode(first::module());
    const TypeInfo& type = *workspace().document.types().find("Walker");
    std::vector<ObjectId> ids{player()};
    for (const ObjectId id : workspace().document.objects()) {
        if (workspace().document.nameOf(id) == "ground") ids.push_back(id);
    }
    ASSERT_EQ(ids.size(), 2u);
    for (const ObjectId id : ids) {  // so that the field is on the screen
        World& world = workspace().document.world;
        world.remove<Sprite>(workspace().document.find(id));
        world.remove<BoxCollider>(workspace().document.find(id));
        world.remove<RigidBody>(workspace().document.find(id));
        world.remove<StaticBody>(workspace().document.find(id));
    }
    workspace().document.world.add(type, workspace().document.find(ids[1]));
    ++workspace().document.sceneRevision;
    setSpeed(100.0f);

    LogBook log;
    ui::EditorWindow window{workspace(), log, nullptr, test::sourceFolder() / "assets/fonts"};
    ui::Hands hands{window};
    workspace().document.selection.set(ids);
    hands.rest(3);
    hands.enterNumber("Inspector/Walker/speed", "x*2+i");
    const auto speedOf = [&](ObjectId id) {
        return static_cast<const first::Walker*>(
                   workspace().document.world.find(type, workspace().document.find(id)))
            ->speed;
    };
    EXPECT_EQ(speedOf(ids[0]), 200.0f);
    EXPECT_EQ(speedOf(ids[1]), 401.0f);
}

TEST_F(ProjectCodeTest, anotherVersionKeepsWhatTheSceneSays) {
    session->useCode(first::module());
    setSpeed(350.0f);
    workspace().document.selection.set({player()});

    session->useCode(second::module());
    ASSERT_NE(edited<second::Walker>(), nullptr);
    EXPECT_EQ(edited<second::Walker>()->pace, 350.0f);
    EXPECT_TRUE(edited<second::Walker>()->tired);
    EXPECT_TRUE(workspace().unsaved());
    EXPECT_EQ(workspace().undo.total(), 0u) << "steps of the undo history refer to fields that are gone";
    EXPECT_TRUE(workspace().document.selection.has(player()));
    EXPECT_NE(workspace().text().find("\"pace\": 350"), std::string::npos);
}

TEST_F(ProjectCodeTest, theSameVersionKeepsTheUndoHistory) {
    session->useCode(first::module());
    setSpeed(350.0f);
    session->useCode(first::module());
    EXPECT_EQ(workspace().undo.total(), 1u);
    EXPECT_TRUE(workspace().undo.undo());
    EXPECT_EQ(edited<first::Walker>()->speed, 200.0f);
}

TEST_F(ProjectCodeTest, aRunningGameGoesOnWithItsState) {
    session->useCode(first::module());
    workspace().startPlaying(true);
    ASSERT_TRUE(workspace().play.running());
    step(5);
    ASSERT_NE(played<first::Walker>(), nullptr);
    EXPECT_EQ(played<first::Walker>()->steps, 5);

    session->useCode(second::module());
    ASSERT_NE(played<second::Walker>(), nullptr);
    EXPECT_EQ(played<second::Walker>()->steps, 5);
    EXPECT_EQ(played<second::Walker>()->pace, 1.0f) << "it had the default of the first version";
    EXPECT_EQ(workspace().play.oldest(), 5) << "the ticks before were simulated by the version before";
    step(3);
    EXPECT_EQ(played<second::Walker>()->steps, 3005);
    workspace().play.seek(6);
    EXPECT_EQ(played<second::Walker>()->steps, 1005) << "rewinding works from the change on";
}

TEST_F(ProjectCodeTest, withoutCodeTheComponentsBecomeTextAgain) {
    session->useCode(first::module());
    workspace().startPlaying(true);
    step(2);
    session->useCode({});
    EXPECT_EQ(played<first::Walker>(), nullptr);
    step(2);
    workspace().stopPlaying();
    EXPECT_EQ(workspace().text(), scene_);
    session->useCode(first::module());
    ASSERT_NE(edited<first::Walker>(), nullptr);
    EXPECT_EQ(workspace().text(), scene_);
}

TEST_F(ProjectCodeTest, errorsOfTheCodeAreReportedOnceByTheCheckAndForbidTheExport) {
    Module wrong = first::module();
    wrong.system<second::WalkerSystem>();
    session->useCode(wrong);
    ASSERT_EQ(session->codeProblems().size(), 1u);
    EXPECT_EQ(session->codeProblems()[0].where, "code: system \"WalkerSystem\"");

    testing::internal::CaptureStdout();
    EXPECT_EQ(session->validate(), 1);
    const std::string output = testing::internal::GetCapturedStdout();
    const std::size_t at = output.find(session->codeProblems()[0].text());
    ASSERT_NE(at, std::string::npos) << output;
    EXPECT_EQ(output.find(session->codeProblems()[0].text(), at + 1), std::string::npos) << output;

    const Path exported = session->workspace().project.root / "exported";
    EditorOptions options;
    options.exportTo = exported.string();
    EXPECT_EQ(session->exportGame(options), 1);
    EXPECT_FALSE(std::filesystem::exists(exported));
    session->useCode(first::module());
    EXPECT_TRUE(session->codeProblems().empty());
}

TEST_F(ProjectCodeTest, aLibraryIsLoadedWithItsTypesAndSystems) {
    const Result<SharedLibrary> library = SharedLibrary::load(PLUMB_TEMPLATE_CODE);
    ASSERT_TRUE(library.ok()) << library.error().text();
    auto* const describe = library->find<void(Module&)>("plumbDescribeModule");
    ASSERT_NE(describe, nullptr);
    Module module;
    describe(module);
    session->useCode(std::move(module));
    ASSERT_NE(edited<void>(), nullptr);
    EXPECT_EQ(workspace().text(), scene_);

    workspace().startPlaying(true);
    const Vec2 start = workspace().play.world().get<Transform>(workspace().play.find(player())).position;
    InputFrame right;
    right.set(Key::Right, true);
    for (int i = 0; i < 600; ++i) workspace().play.step(right);
    const Vec2 end = workspace().play.world().get<Transform>(workspace().play.find(player())).position;
    EXPECT_GT(end.x, start.x) << "its system moves the player";
    EXPECT_LT(end.y, 400.0f) << "a player that falls comes back";
}

TEST(CodeTarget, ofAProjectElsewhereIsNamedByItsLineInTheList) {
    const test::TemporaryFolder home;
    const Path folder = std::filesystem::canonical(home.path);
    const Path build = folder / "build folder";
    const auto project = [&](const char* name) {
        EXPECT_TRUE(writeFile(folder / name / "code/game.cpp", "").ok());
        return folder / name;
    };
    const Path one = project("one"), other = project("the other größe");
    std::filesystem::create_directories(build);
    EXPECT_EQ(*codeTarget(one, build), "outside-1");
    EXPECT_EQ(*codeTarget(other, build), "outside-2");
    EXPECT_EQ(*codeTarget(one / "../one", build), "outside-1");
    EXPECT_EQ(*readFile(build / "projects.txt"), one.string() + "\n" + other.string() + "\n");

    const Result<std::string> none = codeTarget(folder / "empty", build);
    ASSERT_FALSE(none.ok());
    EXPECT_EQ(none.error().what, "cmake names no target for it");
}

}  // namespace
}  // namespace plumb::editor
