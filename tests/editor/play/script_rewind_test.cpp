#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "app/game_content.hpp"
#include "app/project.hpp"
#include "core/file.hpp"
#include "core/random.hpp"
#include "editor/model/play/game_session.hpp"
#include "editor/model/play/play_mode.hpp"
#include "scene/components/transform.hpp"
#include "script/script_state.hpp"
#include "tests/app/projects/project_replays.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor {
namespace {

/// Keeps its values in local variables of a coroutine, which only a snapshot of the Lua state contains, and
/// shows them in a property.
constexpr const char* kWanderer = R"(
local Wanderer = script { digest = number {}, hops = integer {} }
function Wanderer:onCreate()
    local way, names = {}, {}
    while true do
        way[#way + 1] = vec(math.random(-9, 9), math.random(-9, 9))
        if #way > 20 then way = {} end
        names["k" .. #way] = self.transform.position
        for _, name in pairs(names) do self.digest = (self.digest * 3 + name.x) % 65536 end
        self.hops = self.hops + 1
        self.transform.position = self.transform.position + (way[#way] or vec(0, 0))
        wait(0.02 * math.random(1, 9))
    end
end
function Wanderer:onTick() if world:tick() % 50 == 0 then emit("beat", self.entity) end end
function Wanderer:onEvent_beat(from) if from == self.entity then self.digest = self.digest + 1 end end
return Wanderer
)";

class ScriptRewind : public testing::Test {
protected:
    static constexpr int kScripts = 300;
    static constexpr std::int64_t kTicks = 1800;

    void SetUp() override {
        ASSERT_TRUE(loaded.ok());
        std::vector<Error> problems;
        static_cast<void>(content.useScripts({{"wanderer", kWanderer}}, problems));
        ASSERT_TRUE(problems.empty()) << problems[0].text();
        const std::string path = "scenes/level3.scene.json";
        const Result<std::string> text = readFile(loaded->root / path);
        ASSERT_TRUE(text.ok());
        std::unique_ptr<PlaySession> session = makeGameSession(*loaded, path, *text, content);
        ASSERT_NE(session, nullptr);
        for (int i = 0; i < kScripts; ++i) {
            const EntityId entity = session->world().createEntity().id();
            session->world().add<Transform>(entity, 10.0f * static_cast<float>(i), 50.0f);
            session->world().add(*content.types().find("Wanderer"), entity);
        }
        play.start(std::move(session));
    }

    Result<Project> loaded = loadProject(test::sourceFolder() / "projects/platformer");
    std::vector<Error> none;
    GameContent content{Module{}, none};
    PlayMode play;
};

TEST_F(ScriptRewind, randomTicksHaveTheSameLocalsAgain) {
    std::vector<std::uint64_t> hashes{play.world().hash()};
    for (std::int64_t tick = 1; tick <= kTicks; ++tick) {
        play.step({});
        hashes.push_back(play.world().hash());
    }
    const auto* state = play.world().findResource<ScriptState>();
    ASSERT_NE(state, nullptr);
    EXPECT_EQ(state->waits.size(), static_cast<std::size_t>(kScripts));
    EXPECT_GT(state->memory.bytes(), 300'000u);
    play.setPaused(true);
    Random random = Random::seeded(7);
    for (int i = 0; i < 200; ++i) {
        const auto tick =
            play.oldest() +
            static_cast<std::int64_t>(random.below(static_cast<std::uint32_t>(kTicks - play.oldest())));
        play.seek(tick);
        ASSERT_EQ(play.world().hash(), hashes[static_cast<std::size_t>(tick)]) << "tick " << tick;
    }
    RecordProperty("recordingMegabytes", static_cast<int>(play.recording().bytes() >> 20));
    EXPECT_LE(play.recording().bytes(), std::size_t{256} << 20);
}

}  // namespace
}  // namespace plumb::editor
