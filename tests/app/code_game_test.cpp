#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>

#include "app/player_options.hpp"
#include "core/file.hpp"
#include "core/text.hpp"
#include "math/color.hpp"
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

TEST_F(CodeGame, itsImageIsScaledByAWholeNumberOfPixels) {
    ASSERT_EQ(run("--frames 2 --screenshot game.png --window 700x400"), 0) << output_;
    const Result<Image> image = decodeImage(*readFile(folder_ / "game.png"), "game.png");
    ASSERT_TRUE(image);
    ASSERT_EQ(image->width, 700);
    const auto at = [&](int x, int y) {
        const std::uint8_t* rgba = image->rgba.data() + static_cast<std::size_t>(y * image->width + x) * 4;
        return Color{rgba[0], rgba[1], rgba[2], rgba[3]};
    };
    constexpr int kLeft = 30, kTop = 20;  // 320 x 180 px, twice as large, in the middle of 700 x 400
    constexpr Color kBlack{0, 0, 0, 255};
    int colors = 0;
    for (int y = 0; y < 400; ++y) {
        for (int x = 0; x < 700; ++x) {
            const bool inside = x >= kLeft && x < 700 - kLeft && y >= kTop && y < 400 - kTop;
            // The first meteor has not come yet, so that nothing is between two pixels of the image.
            ASSERT_EQ(at(x, y), inside ? at(x & ~1, y & ~1) : kBlack) << x << ", " << y;
            colors += inside && at(x, y) != kBlack ? 1 : 0;
        }
    }
    EXPECT_GT(colors, 200'000);
}

TEST_F(CodeGame, theSizeOfTheWindowIsThatOfTheCodeUnlessAnOptionNamesAnother) {
    const std::pair<const char*, PixelSize> rows[] = {
        {"", {960, 540}}, {"--scale 2", {640, 360}}, {"--scale 2 --window 500x300", {500, 300}}};
    for (const auto& [option, size] : rows) {
        ASSERT_EQ(run(format("--frames 1 --screenshot game.png {}", option)), 0) << output_;
        const Result<Image> image = decodeImage(*readFile(folder_ / "game.png"), "game.png");
        ASSERT_TRUE(image);
        EXPECT_EQ(image->width, size.width) << option;
        EXPECT_EQ(image->height, size.height) << option;
    }
}

TEST_F(CodeGame, whatARunRecordsIsReplayed) {
    ASSERT_EQ(run("--frames 40 --record mine.replay --seed 5 --hash"), 0) << output_;
    const std::string recorded = output_.substr(output_.find("hash: "));
    EXPECT_EQ(run("--headless --replay mine.replay --hash"), 0) << output_;
    EXPECT_EQ(output_.substr(output_.find("hash: ")), recorded);
}

/// tests/replay/record_hello.py records it.
TEST_F(CodeGame, itsReplayScoresEndsAndBeginsAgain) {
    const Path replay = test::sourceFolder() / "projects/hello-code/hello.replay";
    ASSERT_EQ(run(format("--headless --replay '{}'", replay.string())), 0) << output_;
    int games = 0, best = 0, score = 0;
    constexpr std::string_view kWords = "Game over with score ";
    for (std::size_t at = output_.find(kWords); at != std::string::npos; at = output_.find(kWords, at + 1)) {
        const std::string_view rest = std::string_view{output_}.substr(at + kWords.size());
        score = static_cast<int>(*parseInt(rest.substr(0, rest.find(','))));
        best = std::max(best, score);
        ++games;
        EXPECT_EQ(output_.find(format("{}, best {}\n", score, best), at), at + kWords.size());
    }
    EXPECT_GE(games, 2);
    EXPECT_GT(best, 0);

    std::string text = *readFile(replay);
    text.replace(text.find("seed ") + 5, 16, "00000000000000ff");
    ASSERT_TRUE(writeFile(folder_ / "other.replay", text));
    EXPECT_EQ(run("--headless --replay other.replay"), 1) << "with another seed the game must differ";
    EXPECT_NE(output_.find("differs from the recorded one"), std::string::npos) << output_;
}

TEST_F(CodeGame, anErrorNamesTheVariableThatTheOptionIsIn) {
    setenv("PLUMB_OPTIONS", "--headless  --seed 3", 1);
    EXPECT_EQ(run("--replay a.replay"), 2);
    EXPECT_NE(output_.find("PLUMB_OPTIONS: --seed cannot be used with --replay"), std::string::npos)
        << output_;
    EXPECT_EQ(run("--frames"), 2);
    EXPECT_NE(output_.find("command line: --frames needs a value"), std::string::npos) << output_;
    setenv("PLUMB_OPTIONS", "--headles", 1);
    EXPECT_EQ(run("--frames 1"), 2);
    EXPECT_NE(output_.find("PLUMB_OPTIONS: unknown option"), std::string::npos) << output_;
    setenv("PLUMB_OPTIONS", "--headless --frames 9", 1);
    EXPECT_EQ(run("--frames 1 --hash-every 1"), 0) << output_;
    EXPECT_EQ(output_.find("hash 2: "), std::string::npos) << "the command line counts: " << output_;
    unsetenv("PLUMB_OPTIONS");
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
