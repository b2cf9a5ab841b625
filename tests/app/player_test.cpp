#include "app/player.hpp"

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "core/log.hpp"
#include "scene/systems/physics_system.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

struct Sleeper {
    void update(World&, float) const {}
};

/// A project with an empty scene, played without a window.
class PlayerTest : public testing::Test {
protected:
    PlayerTest() {
        before_ = setLogSink([this](const LogLine& line) {
            if (line.level >= LogLevel::Warning) reported.push_back(line.text);
        });
        EXPECT_TRUE(
            writeFile(folder_.path / "project.json", R"({"startScene": "scenes/a.scene.json"})").ok());
        EXPECT_TRUE(writeFile(folder_.path / "scenes/a.scene.json", R"({"format": 1, "entities": []})").ok());
        options.project = folder_.path.string();
        options.headless = true;
        options.frames = 3;
    }
    ~PlayerTest() override { setLogSink(before_); }

    std::vector<std::string> reported;
    PlayerOptions options;

private:
    test::TemporaryFolder folder_;
    LogSink before_;
};

TEST_F(PlayerTest, playsAProjectWhoseCodeIsValid) {
    Module code;
    code.system<Sleeper>(before<PhysicsSystem>());
    EXPECT_EQ(playProject(options, code), 0);
    EXPECT_TRUE(reported.empty()) << reported.front();
}

TEST_F(PlayerTest, doesNotStartWithErrorsOfTheCodeAndReportsEachOnce) {
    Module code;
    code.system<Sleeper>({.after = "Physic"});
    EXPECT_EQ(playProject(options, code), 1);
    EXPECT_EQ(reported,
              (std::vector<std::string>{
                  "code: system \"Sleeper\": there is no system \"Physic\" to run before or after; use "
                  "a system of the engine, e.g. before<PhysicsSystem>(), or one that the code adds "
                  "earlier"}));
}

}  // namespace
}  // namespace plumb
