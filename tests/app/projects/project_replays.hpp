#pragma once

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/project.hpp"
#include "core/file.hpp"
#include "core/text.hpp"
#include "input/recorder.hpp"
#include "tests/app/projects/project_content.hpp"
#include "tests/support/places.hpp"

namespace plumb {

/// A project and a recorded replay of it, which visits several of its scenes or plays one of them.
struct ProjectReplay {
    const char* project;
    const char* replay;
    const char* scene = "";  ///< the only scene of the replay; empty: several, from the start scene
};

inline constexpr ProjectReplay kPinballReplay{"physics-playground", "pinball.replay", "pinball"};

/// At least one replay for every project with scenes; ProjectReplays.noProjectIsLeftOut checks that none is
/// missing.
inline constexpr std::array kProjectReplays{
    ProjectReplay{"platformer", "platformer.replay"},  // created by solve_platformer.cpp
    ProjectReplay{"physics-playground", "playground.replay"},
    ProjectReplay{"physics-lab", "lab.replay"},
    kPinballReplay,
};

/// Name of a replay in names of tests: "platformer".
inline std::string testNameOf(const testing::TestParamInfo<ProjectReplay>& row) {
    const std::string file = row.param.replay;
    return file.substr(0, file.find('.'));
}

inline Path pathOf(const ProjectReplay& row) { return test::sourceFolder() / "tests/replay" / row.replay; }

inline Replay replayOf(const ProjectReplay& row) {
    const Result<Replay> replay = loadReplay(pathOf(row));
    EXPECT_TRUE(replay.ok()) << row.replay;
    return replay ? *replay : Replay{};
}

inline Project projectOf(const ProjectReplay& row) {
    Result<Project> project = loadProject(test::sourceFolder() / "projects" / row.project);
    EXPECT_TRUE(project.ok()) << row.project;
    return *project;
}

/// Returns the input of a replay, one frame per tick.
inline std::vector<InputFrame> framesOf(const Replay& replay) {
    std::vector<InputFrame> frames;
    ReplayPlayer player{replay};
    while (const InputFrame* frame = player.next()) frames.push_back(*frame);
    return frames;
}

}  // namespace plumb
