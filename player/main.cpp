#include <cstdio>
#include <span>
#include <vector>

#include "app/player.hpp"
#include "core/crash.hpp"

/// The standalone player: opens a project and plays its scenes.
int main(int count, char** arguments) {
    plumb::reportCrashes("to find the line of the code, run it in a debugger: ./plumb play PROJECT --debug");
    const std::vector<const char*> words(arguments + 1, arguments + count);
    const auto options = plumb::parsePlayerOptions(words);
    if (!options) {
        std::fprintf(stderr, "plumb-player: %s\n", options.error().text().c_str());
        return 2;
    }
    if (options->help) {
        std::fputs(plumb::playerUsage().c_str(), stdout);
        return 0;
    }
    plumb::Module code;
    plumbDescribeModule(code);
    return plumb::playProject(*options, code);
}
