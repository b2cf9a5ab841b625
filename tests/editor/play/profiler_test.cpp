#include "editor/model/profiler/profiler.hpp"

#include <imgui.h>

#include "editor/model/play/game_session.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor {
namespace {

using Sample = Profiler::Sample;

Sample sampleOf(std::int64_t tick, float milliseconds, std::vector<float> zones = {}) {
    Sample sample;
    sample.tick = tick;
    sample.milliseconds = milliseconds;
    sample.zones = std::move(zones);
    return sample;
}

TEST(ProfilerRows, areSortedByCostWithTheStagesBelowThePhysics) {
    const std::vector<Profiler::Zone> zones{
        {"camera"}, {"solve", true}, {"physics"}, {"broad phase", true}, {"patrol"}};
    const std::deque<Sample> samples{sampleOf(1, 6.0f, {0.5f, 1.0f, 3.0f, 2.0f, 1.0f}),
                                     sampleOf(2, 9.0f, {0.5f, 1.0f, 5.0f, 4.0f, 7.0f}),
                                     sampleOf(3, 2.0f, {0.5f, 1.0f, 4.0f})};
    const auto rows = rowsOf(samples, zones, 1);
    std::vector<std::string_view> names;
    for (const auto& row : rows) names.push_back(zones[row.zone].name);
    EXPECT_EQ(names, (std::vector<std::string_view>{"physics", "broad phase", "solve", "patrol", "camera"}));
    EXPECT_FLOAT_EQ(rows[0].mean, 4.0f);
    EXPECT_FLOAT_EQ(rows[0].worst, 5.0f);
    EXPECT_EQ(rows[0].worstTick, 2);
    EXPECT_FLOAT_EQ(rows[3].chosen, 7.0f);
    EXPECT_FLOAT_EQ(rows[3].mean, 8.0f / 3.0f) << "where it did not run it cost nothing";
}

TEST(ProfilerRows, showTheMeanTimeOfEachThread) {
    std::deque<Sample> samples{sampleOf(1, 6.0f, {4.0f}), sampleOf(2, 6.0f, {2.0f})};
    samples[0].threads = {{3.0f, {3.0f, 2.0f}}};
    samples[1].threads = {{}};  // one thread ran all tasks
    const auto rows = rowsOf(samples, {{"solve", true}}, 0);
    EXPECT_FLOAT_EQ(rows[0].threads.shared, 1.5f);
    ASSERT_EQ(rows[0].threads.busy.size(), 2u);
    EXPECT_FLOAT_EQ(rows[0].threads.busy[0], 1.5f);
    EXPECT_FLOAT_EQ(rows[0].threads.busy[1], 1.0f);
}

TEST(ProfilerRows, spikesAreTicksFarAboveTheTypicalTime) {
    std::deque<Sample> samples;
    for (int i = 0; i < 100; ++i) samples.push_back(sampleOf(i, i % 2 == 0 ? 1.0f : 1.3f));
    EXPECT_TRUE(spikesOf(samples).empty());
    samples[40].milliseconds = 6.0f;
    samples[77].milliseconds = 3.5f;
    EXPECT_EQ(spikesOf(samples), (std::vector<std::size_t>{40, 77}));
    for (Sample& sample : samples) sample.milliseconds *= 0.01f;
    EXPECT_TRUE(spikesOf(samples).empty()) << "what is small anyway disturbs no user";
    EXPECT_TRUE(spikesOf({}).empty());
}

class ProfilerTest : public EditorFixture {
protected:
    ProfilerTest() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        workspace.makeSession = [this](const std::string& path, const std::string& text) {
            Project project;
            project.root = workspace.project.root;
            return makeGameSession(project, path, text);
        };
    }
    void playPausedAt(std::int64_t tick) {
        if (!workspace.play.running()) workspace.startPlaying(true);
        while (workspace.play.ticks() < tick) step();
    }
    void step() {
        hands.key(Key::F10);
        hands.rest();
    }
    [[nodiscard]] std::string valueOf(std::string_view widget) {
        hands.rest(2);
        const auto* found = window.widgets().find(widget);
        return found == nullptr ? "(none)" : found->value;
    }
    [[nodiscard]] const std::deque<Sample>& samples() const { return workspace.profiler.samples(); }

    LogBook log;
    ui::EditorWindow window;
    ui::Hands hands;
};

TEST_F(ProfilerTest, aHiddenProfilerMeasuresNothing) {
    playPausedAt(5);
    EXPECT_TRUE(samples().empty());
    EXPECT_EQ(workspace.play.tickListener, nullptr);
    EXPECT_EQ(workspace.play.world().service<Profile>(), nullptr);
    hands.click("Tab/Profiler");
    hands.rest(3);
    playPausedAt(8);
    EXPECT_EQ(samples().size(), 3u);
    hands.click("Tab/Console");
    hands.rest(3);
    playPausedAt(12);
    EXPECT_EQ(samples().size(), 3u);
    EXPECT_EQ(workspace.play.tickListener, nullptr);
    EXPECT_FALSE(workspace.play.world().service<Profile>()->on);
}

TEST_F(ProfilerTest, everySystemAndStageOfATickIsListedWithItsCounts) {
    hands.click("Tab/Profiler");
    EXPECT_NE(valueOf("Profiler/empty"), "(none)");
    playPausedAt(3);
    ASSERT_EQ(samples().size(), 3u);
    for (const char* zone : {"physics", "solve", "broad phase", "camera", "patrol"})
        EXPECT_NE(valueOf(std::string{"Profiler/zone/"} + zone), "(none)") << zone;
    EXPECT_EQ(valueOf("Profiler/count/entities"), std::to_string(workspace.play.world().entityCount()));
    EXPECT_EQ(samples().back().counts.awake, 1u) << "the player falls";
    EXPECT_EQ(samples().back().tick, 3);
    EXPECT_FALSE(samples().back().again);
}

TEST_F(ProfilerTest, measuringChangesNothingInTheGame) {
    // The game reads the mouse position: both runs keep the mouse and the height of the pane unchanged.
    hands.click("Tab/Profiler");
    workspace.settings.layout.show("Input");
    hands.rest(3);
    playPausedAt(30);
    ASSERT_TRUE(samples().empty());
    const std::uint64_t alone = workspace.play.world().hash();
    workspace.stopPlaying();
    workspace.settings.layout.show("Profiler");
    hands.rest(3);
    playPausedAt(30);
    ASSERT_EQ(samples().size(), 30u);
    EXPECT_EQ(workspace.play.world().hash(), alone);
}

TEST_F(ProfilerTest, scrubbingMeasuresTheReplayedTicks) {
    hands.click("Tab/Profiler");
    playPausedAt(20);
    workspace.play.seek(7);
    ASSERT_GT(samples().size(), 20u);
    EXPECT_TRUE(samples().back().again);
    EXPECT_EQ(samples().back().tick, 7);
}

TEST_F(ProfilerTest, aClickOnATickFreezesTheGraphAndSeeksTheGame) {
    hands.click("Tab/Profiler");
    playPausedAt(40);
    hands.rest(2);
    const auto* graph = window.widgets().find("Profiler/graph");
    ASSERT_NE(graph, nullptr);
    // The newest tick is at the right edge of the graph; each tick is 3 px wide.
    hands.clickAt({graph->box.max.x - 31.0f, graph->box.center().y});
    EXPECT_EQ(valueOf("Profiler/hold"), "on");
    EXPECT_NE(valueOf("Profiler/summary").find("tick 30:"), std::string::npos) << valueOf("Profiler/summary");
    step();
    EXPECT_EQ(samples().size(), 40u) << "it is held";
    hands.click("Profiler/go");
    EXPECT_EQ(workspace.play.ticks(), 30);
    hands.click("Profiler/hold");
    EXPECT_EQ(valueOf("Profiler/hold"), "off");
    EXPECT_NE(valueOf("Profiler/summary").find("tick 40:"), std::string::npos);
}

TEST_F(ProfilerTest, anotherGameClearsTheSamples) {
    hands.click("Tab/Profiler");
    playPausedAt(10);
    workspace.stopPlaying();
    hands.rest(2);
    EXPECT_EQ(samples().size(), 10u) << "what was measured can still be looked at";
    playPausedAt(2);
    EXPECT_EQ(samples().size(), 2u);
}

}  // namespace
}  // namespace plumb::editor
