#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "assets/asset_store.hpp"
#include "core/text.hpp"
#include "tests/support/places.hpp"

namespace plumb {
namespace {

/// Loads all asset files of a project and returns the errors.
std::vector<Error> problemsOf(const Path& project) {
    AssetStore assets{project, test::sourceFolder() / "assets"};
    assets.logging = false;
    for (const std::string& path : filesBelow(project, "")) {
        if (endsWith(path, ".png")) static_cast<void>(assets.image(assets.loadTexture(path)));
        if (endsWith(path, ".tileset.json")) assets.loadTileset(path);
        if (endsWith(path, ".anim.json")) assets.loadAnimation(path);
        if (endsWith(path, ".wav") || endsWith(path, ".ogg")) assets.loadSound(path);
        if (endsWith(path, ".ttf")) assets.loadFont(path);
    }
    return assets.errors();
}

TEST(ProjectAssets, everyAssetOfEveryProjectLoadsWithoutAProblem) {
    for (const auto& entry : std::filesystem::directory_iterator{test::sourceFolder() / "projects"}) {
        if (!entry.is_directory()) continue;
        for (const Error& problem : problemsOf(entry.path()))
            ADD_FAILURE() << entry.path() << ": " << problem.text();
    }
}

TEST(ProjectAssets, everyTilesetAndAnimationOfEveryProjectIsWrittenBackByteForByte) {
    const Path projects = test::sourceFolder() / "projects";
    std::vector<Error> problems;
    for (const std::string& path : filesBelow(projects, ".tileset.json")) {
        const std::string text = *readFile(projects / path);
        EXPECT_EQ(writeTileset(*parseTileset(text, path, problems)), text) << path;
    }
    for (const std::string& path : filesBelow(projects, ".anim.json")) {
        const std::string text = *readFile(projects / path);
        EXPECT_EQ(writeAnimationSet(*parseAnimationSet(text, path, problems)), text) << path;
    }
}

}  // namespace
}  // namespace plumb
