#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/game_content.hpp"
#include "app/project.hpp"
#include "editor/model/play/game_session.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor {

/// Counts its ticks in a variable that only the Lua state has, and shows them in properties. In each third
/// tick it adds a hit. The tests name its lines by their numbers.
inline constexpr const char* kCounter = R"(local Counter = script { far = number {}, hits = integer {} }
local function twice(x)
    local y = x * 2
    return y
end
function Counter:onCreate()
    self.count = 0
end
function Counter:onTick(dt)
    self.count = self.count + 1
    local far = twice(self.count)
    if far % 6 == 0 then
        self.hits = self.hits + 1
    end
    self.far = far
end
return Counter
)";

/// Games of one scene with two entities, "first" and "second", that have the script `scripts/counter.lua`.
class ScriptGame {
public:
    using Texts = std::vector<std::pair<std::string, std::string>>;

    explicit ScriptGame(const Texts& scripts = {{"counter", kCounter}}) {
        std::vector<Error> problems;
        static_cast<void>(content.useScripts(scripts, problems));
        EXPECT_TRUE(problems.empty()) << problems[0].text();
    }

    [[nodiscard]] std::unique_ptr<PlaySession> start(const std::string& scene = kCounters) const {
        Project project;
        project.root = test::sourceFolder() / "projects/platformer";
        std::unique_ptr<PlaySession> session =
            makeGameSession(project, "scenes/counters.scene.json", scene, content);
        EXPECT_NE(session, nullptr);
        return session;
    }

    static constexpr const char* kCounters = R"({"format": 1, "entities": [
        {"id": "00000000000000a1", "name": "first", "components": {"Transform": {}, "Counter": {}}},
        {"id": "00000000000000a2", "name": "second", "components": {"Transform": {}, "Counter": {}}}]})";

private:
    std::vector<Error> none_;

public:
    GameContent content{Module{}, none_};
};

}  // namespace plumb::editor
