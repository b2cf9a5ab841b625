#include "app/effect_list.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "core/profile.hpp"
#include "gameplay/components/music.hpp"
#include "tests/app/effects/effect_games.hpp"

namespace plumb {
namespace {

using test::PileGame;

/// Returns the line of the table that begins with this name.
std::string lineOf(const std::string& table, const std::string& name) {
    const std::size_t at = table.find("\n  " + name + "  ");
    return at == std::string::npos ? "" : table.substr(at + 1, table.find('\n', at + 1) - at - 1);
}

std::string tableOf(PileGame& game) {
    return effectText(reportEffects(game.world, game.effects, nullptr, 0));
}

TEST(EffectList, listsRunningEffectsAndTheirUsers) {
    PileGame game;
    game.play(1);
    const std::string before = tableOf(game);
    EXPECT_EQ(lineOf(before, "particles"),
              "  particles            no    -                 -       -         -  none of: ParticleEmitter");
    EXPECT_EQ(lineOf(before, "gravity"),
              "  gravity              yes   -                 -       -         -  RigidBody (12)");
    EXPECT_NE(lineOf(before, "sound").find("no "), std::string::npos);
    game.world.createEntity().addComponent<ParticleEmitter>();
    game.world.createEntity().addComponent<Music>();
    game.effects.setProgramPin("particles", Pin::On);
    const std::string after = tableOf(game);
    EXPECT_EQ(lineOf(after, "particles"),
              "  particles            yes   on                -       -         -  ParticleEmitter (1)");
    EXPECT_EQ(lineOf(after, "sound"),
              "  sound                yes   -                 -       -         -  Music (1)");
}

TEST(EffectList, everyColumnIsBelowItsTitle) {
    PileGame game;
    game.play(1);
    const std::string table = tableOf(game);
    const std::size_t requesters = table.find("requested by");
    ASSERT_LT(requesters, table.find('\n'));
    for (const EffectRow& row : engineEffects().rows()) {
        const std::string line = lineOf(table, std::string{row.name});
        ASSERT_GT(line.size(), requesters) << row.name;
        EXPECT_EQ(line[requesters - 1], ' ') << line;
        EXPECT_NE(line[requesters], ' ') << line;
    }
}

TEST(EffectList, measuringReportsCostsAndDoesNotChangeTheGame) {
    PileGame game, same;
    Profile profile;
    const EffectReport report = measureEffects(game, profile, 20);
    EXPECT_EQ(report.ticks, 20);
    EXPECT_GT(report.microseconds, 0.0);
    same.play(20);  // as many ticks as the measurement runs for warming up
    EXPECT_EQ(game.world.hash(), same.world.hash());
    for (const EffectLine& line : report.lines) {
        EXPECT_EQ(game.effects.pinOf(line.row), Pin::Auto);
        const bool costs = line.microseconds > 0.0;
        EXPECT_TRUE(!costs || line.runs) << engineEffects().rows()[line.row].name;
    }
    // On a busy machine reading the clock may take longer than the measured work, which is then reported as
    // 0.
    const EffectLine& sleep = report.lines[engineEffects().find("sleep")];
    EXPECT_EQ(sleep.zones.own, std::vector<std::string_view>{"sleep"});
    const auto zones = profile.zones();
    const auto zone = std::find_if(zones.begin(), zones.end(),
                                   [](const Profile::Zone& which) { return which.name == "sleep"; });
    ASSERT_NE(zone, zones.end());
    EXPECT_GT(zone->calls, 0);
    EXPECT_LE(sleep.microseconds, 1e6 * zone->seconds / report.ticks);
}

TEST(EffectList, aZoneSharedByEffectsIsNotAssignedToOne) {
    const EffectTable& table = engineEffects();
    const EffectZones contacts = zonesOf(table, table.find("contacts"));
    EXPECT_TRUE(contacts.own.empty());
    EXPECT_NE(std::find(contacts.shared.begin(), contacts.shared.end(), "broad phase"),
              contacts.shared.end());
    EXPECT_EQ(zonesOf(table, table.find("friction")).shared, std::vector<std::string_view>{"solve"});
    EXPECT_EQ(zonesOf(table, table.find("players")).own,
              (std::vector<std::string_view>{"player controller", "pause"}));
}

}  // namespace
}  // namespace plumb
