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
