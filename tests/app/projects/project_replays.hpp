#pragma once

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/project.hpp"
#include "core/file.hpp"
#include "core/text.hpp"
#include "input/recorder.hpp"
#include "tests/support/places.hpp"

namespace plumb {

/// A project of scenes and its recorded game, which goes through several of them.
struct ProjectReplay {
    const char* project;
    const char* replay;
};

/// One for every project of scenes; a test watches that none is left out.
inline constexpr std::array kProjectReplays{
    ProjectReplay{"platformer", "platformer.replay"},  // made by solve_platformer.cpp
    ProjectReplay{"physics-playground", "playground.replay"},
    ProjectReplay{"physics-lab", "lab.replay"},
};

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

/// One frame a tick.
inline std::vector<InputFrame> framesOf(const Replay& replay) {
    std::vector<InputFrame> frames;
    ReplayPlayer player{replay};
    while (const InputFrame* frame = player.next()) frames.push_back(*frame);
    return frames;
}

}  // namespace plumb
