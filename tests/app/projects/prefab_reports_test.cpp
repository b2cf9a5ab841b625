#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/scene_game.hpp"
#include "core/log.hpp"
#include "gameplay/game_functions.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {

// Components must not be in an unnamed namespace.
namespace prefab_reports {

struct Gun {
    PrefabId bullet;

    static void describe(TypeBuilder<Gun>& type) {
        type.name("Gun");
        type.field<&Gun::bullet>("bullet");
    }
};

Module code() {
    Module module;
    module.components<Gun>();
    return module;
}

}  // namespace prefab_reports

namespace {

constexpr const char* kBullet = "prefabs/bullet.prefab.json";

/// A game whose scene has a gun, which names a prefab that no scene contains.
class PrefabReports : public testing::Test {
protected:
    PrefabReports() {
        before_ = setLogSink([this](const LogLine& line) {
            if (line.level >= LogLevel::Warning) reported.push_back(line.text);
        });
        write("scenes/main.scene.json", R"({"format": 1, "effects": {}, "layers": [], "entities": [
            {"id": "1", "components": {"Gun": {"bullet": "prefabs/bullet.prefab.json"}}}]})");
    }
    ~PrefabReports() override { setLogSink(before_); }

    void write(const std::string& path, const std::string& text) {
        ASSERT_TRUE(writeFile(folder.path / path, text).ok());
    }
    void writeBullet(const std::string& components) {
        write(kBullet, R"({"format": 1, "entities": [{"id": "1", "components": )" + components + "}]}");
    }
    [[nodiscard]] Project project() const {
        return *projectFromText(R"({"startScene": "scenes/main.scene.json"})", folder.path, "project.json");
    }

    test::TemporaryFolder folder;
    std::vector<Error> problems;
    GameContent content{prefab_reports::code(), problems};
    std::vector<std::string> reported;

private:
    LogSink before_;
};

TEST_F(PrefabReports, aPrefabThatIsOnlyNamedIsCheckedWithTheSceneAndItsSpawnsAreSilent) {
    writeBullet(R"({"Transform": {}, "Sprite": {"widht": 4, "texture": "assets/none.png"}})");
    SceneGame game{project(), {}, 1, content};
    game.onCreate();
    ASSERT_EQ(reported.size(), 2u);
    EXPECT_EQ(reported[0],
              "prefabs/bullet.prefab.json: entities[0].Sprite.widht: Sprite has no such field; it is kept "
              "unchanged; did you mean \"width\"?");
    EXPECT_EQ(reported[1].find("assets/none.png: there is no such file"), 0u) << reported[1];
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(spawn(game.world, PrefabId{textId(kBullet)}, {}));
        tickGame(game, {});
    }
    ASSERT_TRUE(game.openScene("scenes/main.scene.json"));
    EXPECT_EQ(reported.size(), 2u) << reported.back();
}

TEST_F(PrefabReports, spawningANamedPrefabLoadsNoFile) {
    write("assets/spark.anim.json", R"({"format": 1, "image": "assets/none.png", "clips": []})");
    writeBullet(R"({"Transform": {}, "Animator": {"animation": "assets/spark.anim.json"}})");
    SceneGame game{project(), {}, 1, content};
    game.assets.logging = false;
    game.onCreate();
    const std::size_t loads = game.assets.loadCount();
    ASSERT_TRUE(game.spawn(PrefabId{textId(kBullet)}, {}));
    EXPECT_EQ(game.assets.loadCount(), loads);
    EXPECT_GT(game.assets.references(AssetKind::Animation, textId("assets/spark.anim.json")), 0);
}

TEST_F(PrefabReports, aChangedFileIsReadAgainForTheNextSpawnAndReportedAgain) {
    writeBullet(R"({"Transform": {}, "Sprite": {"width": 4}})");
    SceneGame game{project(), {}, 1, content};
    game.onCreate();
    EXPECT_TRUE(reported.empty()) << reported.front();
    EXPECT_EQ(game.spawn("bullet", {}).get<Sprite>().width, 4);

    writeBullet(R"({"Transform": {}, "Sprite": {"width": 16, "heihgt": 4}})");
    const std::vector<AssetChange> changes = game.assets.pollChanges(game.assets.size());
    ASSERT_EQ(changes.size(), 1u);
    EXPECT_EQ(changes[0].kind, AssetKind::Prefab);
    game.followChanges(changes);
    ASSERT_EQ(reported.size(), 1u);
    EXPECT_NE(reported[0].find("Sprite.heihgt"), std::string::npos) << reported[0];
    EXPECT_EQ(game.spawn("bullet", {}).get<Sprite>().width, 16);
    EXPECT_EQ(reported.size(), 1u);
}

TEST_F(PrefabReports, aMissingPrefabThatAFieldNamesIsReportedOnce) {
    SceneGame game{project(), {}, 1, content};
    game.onCreate();
    ASSERT_EQ(reported.size(), 1u);
    EXPECT_EQ(reported[0].find("prefabs/bullet.prefab.json: there is no such file"), 0u) << reported[0];
}

}  // namespace
}  // namespace plumb
