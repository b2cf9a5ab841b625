#pragma once

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/game_content.hpp"
#include "app/project.hpp"
#include "app/scene_game.hpp"

namespace plumb {

/// Content for a project without code: the engine's components and those of the project's scripts. Types of
/// scripts are known by their names in the whole program, so keep it only as long as the games that use it.
class ProjectContent {
public:
    explicit ProjectContent(const Project& project) {
        static_cast<void>(content_.readScripts(project.root, problems_));
        for (const Error& problem : problems_) ADD_FAILURE() << problem.text();
    }

    [[nodiscard]] const GameContent& operator*() const { return content_; }

private:
    std::vector<Error> problems_;
    GameContent content_{Module{}, problems_};
};

/// A project that is played without a window, with its scripts.
struct ProjectGame {
    ProjectContent content;
    SceneGame game;

    /// @param scene  the first scene; empty: the project's start scene
    explicit ProjectGame(Project project, std::string scene = {})
        : content{project}, game{std::move(project), std::move(scene), 1, *content} {
        game.assets.logging = false;
    }
};

}  // namespace plumb
