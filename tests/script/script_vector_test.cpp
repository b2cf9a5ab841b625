#include "script/script_vector.hpp"

#include "tests/script/script_world.hpp"

namespace plumb {
namespace {

using ScriptVectors = ScriptWorld;

TEST_F(ScriptVectors, areValuesThoughEqualOnesMayBeOneObject) {
    thing(R"(
        function Thing:onTick()
            local kept = {}
            for i = 1, 2000 do kept[i] = vec(i % 500, -i) end
            for i = 1, 2000 do
                local same = vec(i % 500, -i)
                assert(kept[i] == same and kept[i].x == i % 500 and kept[i].y == -i, i)
                assert(kept[i] ~= vec(i % 500, i))
            end
            local before = self.transform.position
            self.transform.position = before + vec(1, 2)
            assert(before == vec(0, 0) and self.transform.position == vec(1, 2))
            self.transform.position = before
        end
    )");
    run(3);
    EXPECT_EQ(logText(), "");
}

TEST_F(ScriptVectors, keepTheSignOfZeroAndAreNotEqualWithoutANumber) {
    thing(R"(
        function Thing:onTick()
            local plus, minus = vec(0, 1), vec(-0.0, 1)
            assert(1 / plus.x == math.huge and 1 / minus.x == -math.huge and plus == minus)
            local none = vec(0 / 0, 1)
            assert(none.x ~= none.x and vec(0 / 0, 1) ~= vec(0 / 0, 1))
        end
    )");
    run(2);
    EXPECT_EQ(logText(), "");
}

TEST_F(ScriptVectors, areNotMistakenForOtherValues) {
    thing(R"(
        function Thing:onTick()
            for _, wrong in ipairs({ 5, "x", self.entity, self.transform, {}, print, self }) do
                local ok, message = pcall(vec(1, 2).dot, vec(1, 2), wrong)
                assert(not ok and message:find("vec expected"), message)
                ok, message = pcall(function() self.transform.position = wrong end)
                assert(not ok and message:find("expected a vector"), message)
                assert(vec(1, 2) ~= wrong)
            end
            local ok, message = pcall(self.entity.has, vec(1, 2), "Sprite")
            assert(not ok and message:find("entity expected"), message)
            ok, message = pcall(tween, self.entity, { x = 1 }, 1)
            assert(not ok and message:find("component expected"), message)
        end
    )");
    run();
    EXPECT_EQ(logText(), "");
}

}  // namespace
}  // namespace plumb
