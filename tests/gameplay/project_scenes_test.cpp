#include <cstdlib>

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "ecs/world.hpp"
#include "gameplay/register_components.hpp"
#include "reflect/type_registry.hpp"
#include "scene/files/prefab.hpp"
#include "scene/files/scene_file.hpp"
#include "scene/register_components.hpp"
#include "tests/support/places.hpp"

namespace plumb {
namespace {

TEST(ProjectScenes, goldenOpenAndSaveChangesNoByteOfAnyScene) {
    TypeRegistry types;
    registerSceneComponents(types);
    registerGameplayComponents(types);
    const Path projects = test::sourceFolder() / "projects";
    const std::vector<std::string> scenes = filesBelow(projects, ".scene.json");
    EXPECT_FALSE(scenes.empty());
    for (const std::string& name : scenes) {
        SCOPED_TRACE(name);
        const std::size_t folder = name.find('/');
        PrefabLibrary prefabs{types, projects / name.substr(0, folder)};
        const SceneContext context{types, &prefabs, projects / name.substr(0, folder)};
        const std::string path = name.substr(folder + 1);
        const auto text = readFile(projects / name);
        ASSERT_TRUE(text) << text.error().text();

        World world{types};
        const auto report = loadScene(world, context, path, *text);
        ASSERT_TRUE(report) << report.error().text();
        // Components of a project's code and scripts are unknown here; the scene keeps them unchanged.
        const Path project = projects / name.substr(0, folder);
        const bool hasCode =
            std::filesystem::exists(project / "code") || std::filesystem::exists(project / "scripts");
        for (const Error& problem : report->problems) {
            if (!hasCode || problem.what.find("there is no component") == std::string::npos)
                ADD_FAILURE() << problem.text();
        }
        const std::string saved = sceneToJson(world, context, report->scene);
        if (std::getenv("UPDATE_GOLDEN") != nullptr) {
            ASSERT_TRUE(writeFile(projects / name, saved));
        } else {
            EXPECT_TRUE(saved == *text)
                << "the engine saves this scene differently: UPDATE_GOLDEN=1 rewrites the file";
        }
    }
}

}  // namespace
}  // namespace plumb
