#pragma once

#include <string>

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "editor/model/play/game_session.hpp"
#include "tests/app/projects/platformer.hpp"
#include "tests/editor/support/played_input.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor {

/// Starts a level of the platformer as the editor plays it.
inline std::unique_ptr<PlaySession> platformerSession(const std::string& scene = "scenes/level2.scene.json") {
    const Project project = platformer();
    const Result<std::string> text = readFile(project.root / scene);
    EXPECT_TRUE(text.ok());
    return makeGameSession(project, scene, *text);
}

inline Project playgroundProject() {
    Result<Project> project = loadProject(test::sourceFolder() / "projects/physics-playground");
    EXPECT_TRUE(project.ok());
    return *project;
}

/// Starts the project "physics-playground" with a scene of 500 boxes.
inline std::unique_ptr<PlaySession> playgroundSession() {
    return makeGameSession(playgroundProject(), "scenes/pyramid.scene.json", heapScene(500));
}

}  // namespace plumb::editor
