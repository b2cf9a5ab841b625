#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/project.hpp"
#include "core/file.hpp"
#include "ecs/world.hpp"
#include "scene/components/transform.hpp"
#include "tests/support/places.hpp"

namespace plumb {

inline Project platformer() {
    Result<Project> project = loadProject(test::sourceFolder() / "projects/platformer");
    EXPECT_TRUE(project.ok());
    return *project;
}

/// Paths of the platformer's scenes, relative to its project folder.
inline std::vector<std::string> platformerScenes() {
    std::vector<std::string> scenes;
    for (const std::string& name :
         filesBelow(test::sourceFolder() / "projects/platformer/scenes", ".scene.json")) {
        scenes.push_back("scenes/" + name);
    }
    return scenes;
}

/// Number of entities that moved in the last tick.
inline std::size_t movedEntities(World& world) {
    std::size_t moved = 0;
    for (auto [entity, transform] : world.query<const Transform>()) {
        if (!(transform.position == transform.previousPosition)) ++moved;
    }
    return moved;
}

}  // namespace plumb
