#include "platform/paths.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/environment.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

TEST(Paths, aGameHasTheFileNameOfItsNameWithoutWhatSystemsRefuse) {
    const std::pair<const char*, const char*> names[] = {{"Wickwood", "Wickwood"},
                                                         {"Sky Caves 2", "Sky Caves 2"},
                                                         {"a/b\\c:d", "abcd"},
                                                         {"What?", "What"},
                                                         {"The end...", "The end"},
                                                         {"...", "game"},
                                                         {"", "game"},
                                                         {".hidden", "game"},
                                                         {"Con", "Con_"},
                                                         {"nul", "nul_"},
                                                         {"COM1", "COM1_"},
                                                         {"aux.2", "aux_.2"},
                                                         {"Lpt9 .x", "Lpt9_ .x"},
                                                         {"Console", "Console"},
                                                         {"COM", "COM"},
                                                         {"COM0", "COM0"},
                                                         {"Con 2", "Con 2"},
                                                         {"\u00dcber", "\u00dcber"}};
    for (const auto& [name, file] : names) EXPECT_EQ(fileNameOf(name), file) << name;
}

TEST(Paths, theDataFolderIsThatOfXdgOrInHomeOrAnErrorAndNeverTheCurrentFolder) {
    const test::TemporaryFolder folder;
    const std::string home = folder.path.string(), data = (folder.path / "data").string();
    struct Case {
        const char* data;
        const char* home;
        Path wanted;  // empty: an error
    };
    const Case cases[] = {{data.c_str(), home.c_str(), folder.path / "data/Sky Caves/"},
                          {data.c_str(), nullptr, folder.path / "data/Sky Caves/"},
                          {nullptr, home.c_str(), folder.path / ".local/share/Sky Caves/"},
                          {"relative", home.c_str(), folder.path / ".local/share/Sky Caves/"},
                          {"", home.c_str(), folder.path / ".local/share/Sky Caves/"},
                          {nullptr, nullptr, {}},
                          {"relative", nullptr, {}},
                          {nullptr, "", {}},
                          {nullptr, "relative", {}},
                          {"/dev/null", nullptr, {}}};
    for (const auto& [xdg, user, wanted] : cases) {
        const test::Variable first{"XDG_DATA_HOME", xdg};
        const test::Variable second{"HOME", user};
        const Result<Path> found = dataFolder("Sky Caves");
        EXPECT_EQ(found.ok(), !wanted.empty()) << (xdg ? xdg : "-") << ' ' << (user ? user : "-");
        EXPECT_EQ(found ? *found : Path{}, wanted);
        if (found) continue;
        EXPECT_NE(found.error().remedy.find("--saves DIR"), std::string::npos) << found.error().text();
    }
    EXPECT_FALSE(std::filesystem::exists("relative"));
}

}  // namespace
}  // namespace plumb
