#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "app/player_options.hpp"
#include "core/file.hpp"
#include "core/text.hpp"
#include "platform/image_file.hpp"
#include "tests/support/places.hpp"

// Starts the program of projects/hello-code like a user: with options, from any folder.

namespace plumb {
namespace {

#if !defined(_WIN32)

class CodeGame : public testing::Test {
protected:
    CodeGame() { std::filesystem::create_directories(folder_ / "assets"); }
    ~CodeGame() override { std::filesystem::remove_all(folder_); }

    /// Runs the program in another folder than its own. @return its exit code as reported by the shell
    int run(const std::string& options) {
        const std::string command =
            format("cd '{}' && '{}' {} > output 2>&1", folder_.string(), PLUMB_HELLO_CODE, options);
        const int status = std::system(command.c_str());
        output_ = *readFile(folder_ / "output");
        return WEXITSTATUS(status);
    }

    /// A folder of its own for each test, because tests run in parallel.
    Path folder_ = std::filesystem::temp_directory_path() / "plumb_code_game" /
                   testing::UnitTest::GetInstance()->current_test_info()->name();
    std::string output_;
};

TEST_F(CodeGame, itsImagesAreFoundFromAnyFolder) {
    ASSERT_EQ(run("--frames 30 --screenshot game.png --window 400x300"), 0) << output_;
    const Result<std::string> bytes = readFile(folder_ / "game.png");
    ASSERT_TRUE(bytes) << output_;
    const Result<Image> image = decodeImage(*bytes, "game.png");
    ASSERT_TRUE(image);
    EXPECT_EQ(image->width, 400);
    EXPECT_EQ(image->height, 300);
    int magenta = 0;  // color of the placeholder for missing images
    int drawn = 0;
    for (std::size_t i = 0; i < image->rgba.size(); i += 4) {
        const auto red = image->rgba[i], green = image->rgba[i + 1], blue = image->rgba[i + 2];
        magenta += red > 200 && green < 60 && blue > 200 ? 1 : 0;
        drawn += red != image->rgba[0] || green != image->rgba[1] || blue != image->rgba[2] ? 1 : 0;
    }
    EXPECT_EQ(magenta, 0);
    EXPECT_GT(drawn, 1000);
}

TEST_F(CodeGame, theOptionsAreThoseOfThePlayer) {
    EXPECT_EQ(run("--headless --frames 60 --hash"), 0) << output_;
    EXPECT_NE(output_.find("hash: "), std::string::npos) << output_;
    const std::string headless = output_.substr(output_.find("hash: "));
    EXPECT_EQ(run("--frames 60 --hash --physics-view all"), 0) << output_;
    EXPECT_EQ(output_.substr(output_.find("hash: ")), headless) << "the hash must be the same with rendering";

    const std::string replay = (test::sourceFolder() / "projects/hello-code/hello.replay").string();
    EXPECT_EQ(run(format("--headless --hash-every 50 --replay '{}'", replay)), 0) << output_;
    EXPECT_NE(output_.find("hash 150: "), std::string::npos) << output_;

    EXPECT_EQ(run("--help"), 0);
    EXPECT_EQ(output_, gameUsage("hello-code"));
    EXPECT_NE(output_.find("usage: hello-code [options]"), std::string::npos);
}

TEST_F(CodeGame, unknownOptionsAreRejectedWithARemedy) {
    EXPECT_EQ(run("--nonsense"), 2);
    EXPECT_NE(output_.find("unknown option \"--nonsense\""), std::string::npos) << output_;
    EXPECT_EQ(run("--headles"), 2);
    EXPECT_NE(output_.find("did you mean --headless?"), std::string::npos) << output_;
    EXPECT_EQ(run("--scene level1"), 2) << "a game in code has no option --scene";
    EXPECT_EQ(run("level1"), 2);
    EXPECT_NE(output_.find("run with --help"), std::string::npos) << output_;
    EXPECT_EQ(run("--frames many"), 2);
}

#endif

}  // namespace
}  // namespace plumb
