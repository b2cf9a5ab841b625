#include <cstdio>
#include <string>
#include <vector>

#include "app/player.hpp"
#include "core/crash.hpp"
#include "core/os.hpp"

/// The standalone player: opens a project and plays its scenes.
int main(int count, char** arguments) {
    plumb::reportCrashes("to find the line of the code, run it in a debugger: ./plumb play PROJECT --debug");
    const std::vector<std::string> texts = plumb::os::arguments(count, arguments);
    std::vector<const char*> words;
    for (const std::string& text : texts) words.push_back(text.c_str());
    const std::string game = plumb::exportedName(count > 0 ? arguments[0] : "", PLUMB_PLAYER);
    auto options = plumb::parsePlayerOptions(words);
    if (!options) {
        std::fprintf(stderr, "%s: %s\n", game.empty() ? PLUMB_PLAYER : game.c_str(),
                     options.error().text().c_str());
        return 2;
    }
    if (options->help) {
        std::fputs((game.empty() ? plumb::playerUsage() : plumb::gameUsage(game)).c_str(), stdout);
        return 0;
    }
    options->exportedAs = game;
    plumb::Module code;
    plumbDescribeModule(code);
    return plumb::playProject(*options, code);
}
