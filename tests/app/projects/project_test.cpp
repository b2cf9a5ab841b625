#include "app/project.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "tests/support/places.hpp"

namespace plumb {
namespace {

TEST(Project, aFileWithEverythingIsRead) {
    const auto project = projectFromText(
        R"({"name": "Mine", "startScene": "scenes/a.scene.json", "window": {"width": 640, "height": 360},
            "resolution": [320, 180], "scaling": "integer", "smooth": true, "physics": {"gravity": [0, 500], "layers": ["ground", "", "player"]}})",
        ".", "project.json");

    ASSERT_TRUE(project.ok());
    EXPECT_TRUE(project->warnings.empty());
    EXPECT_EQ(project->name, "Mine");
    EXPECT_EQ(project->windowWidth, 640);
    EXPECT_EQ(project->width, 320);
    EXPECT_EQ(project->scaling, WindowScale::Integer);
    EXPECT_TRUE(project->smooth);
    EXPECT_EQ(project->gravity, (Vec2{0.0f, 500.0f}));
    EXPECT_EQ(project->layers, (std::vector<std::string>{"ground", "", "player"}));
}

TEST(Project, everyWrongValueIsOneWarningWithWhereWhatAndRemedyAndTheDefaultStays) {
    for (const char* wrong :
         {R"({"name": 3})", R"({"scaling": "huge"})", R"({"smooth": "very"})", R"({"resolution": [320]})",
          R"({"resolution": [0, 180]})", R"({"window": {"width": -1}})", R"({"window": 5})",
          R"({"physics": {"pixelsPerMetre": 0}})", R"({"physics": {"gravity": "down"}})",
          R"({"physics": {"layers": "ground"}})", R"({"physics": {"layers": ["ground", 2]}})",
          R"({"startScene": false})"}) {
        SCOPED_TRACE(wrong);
        const auto project = projectFromText(wrong, ".", "project.json");
        ASSERT_TRUE(project.ok());
        ASSERT_EQ(project->warnings.size(), 1u);
        const Error& warning = project->warnings.front();
        EXPECT_EQ(warning.where.substr(0, 12), "project.json");
        EXPECT_FALSE(warning.what.empty());
        EXPECT_FALSE(warning.remedy.empty());
        EXPECT_EQ(project->width, 1280);
    }
}

TEST(Project, anUnknownKeyIsAWarningWithTheNearestKnownOne) {
    const std::pair<const char*, const char*> cases[] = {
        {R"({"startScen": "scenes/a.scene.json"})",
         "project.json: startScen: a project has no such key; it is ignored; did you mean \"startScene\"?"},
        {R"({"window": {"heigth": 3}})",
         "project.json: window.heigth: a project has no such key; it is ignored; did you mean \"height\"?"},
        {R"({"physics": {"gravty": [0, 1]}})",
         "project.json: physics.gravty: a project has no such key; it is ignored; did you mean \"gravity\"?"},
        {R"({"somethingElse": 1})",
         "project.json: somethingElse: a project has no such key; it is ignored; check the spelling or "
         "remove it"}};
    for (const auto& [text, expected] : cases) {
        const auto project = projectFromText(text, ".", "project.json");
        ASSERT_TRUE(project.ok());
        ASSERT_EQ(project->warnings.size(), 1u) << text;
        EXPECT_EQ(project->warnings.front().text(), expected);
    }
}

/// Also guards the list of known keys: a key that a project of ours uses is read.
TEST(Project, theProjectsAndTemplatesHaveOnlyKnownKeys) {
    const std::vector<std::string> files = filesBelow(test::sourceFolder() / "projects", "project.json");
    ASSERT_GE(files.size(), 4u);
    for (const std::string& file : files) {
        const auto project = loadProject(test::sourceFolder() / "projects" / file);
        ASSERT_TRUE(project.ok()) << file;
        for (const Error& warning : project->warnings) ADD_FAILURE() << file << ": " << warning.text();
    }
    for (const std::string& file : filesBelow(test::sourceFolder() / "assets/templates", "project.json")) {
        const auto project = loadProject(test::sourceFolder() / "assets/templates" / file);
        ASSERT_TRUE(project.ok()) << file;
        for (const Error& warning : project->warnings) ADD_FAILURE() << file << ": " << warning.text();
    }
}

TEST(Project, invalidProjectsAreErrors) {
    for (const char* wrong : {"", "[]", "{", "3", "nonsense"}) {
        EXPECT_FALSE(projectFromText(wrong, ".", "project.json").ok()) << wrong;
    }
    EXPECT_EQ(loadProject("/nowhere/at/all").error().what, "there is no such folder");
    EXPECT_EQ(loadProject("/nowhere/project.json").error().what, "there is no such file");
}

}  // namespace
}  // namespace plumb
